# cmake -DROOT=report -DOUT=report_page.cpp -P embed.cmake: the report's style and scripts as a C++ file that
# defines sr::golden::report_page().
function(raw_string file out)
  file(READ "${file}" text)
  string(FIND "${text}" ")__page__\"" end_mark)
  if(NOT end_mark EQUAL -1)
    message(FATAL_ERROR "${file}: contains )__page__\", which ends a raw string: write it otherwise")
  endif()
  set(${out} "R\"__page__(${text})__page__\"" PARENT_SCOPE)
endfunction()

raw_string("${ROOT}/page.css" style)
file(GLOB scripts "${ROOT}/*.js")
list(SORT scripts)
set(script "std::string()")
foreach(file IN LISTS scripts)
  raw_string("${file}" text)
  string(APPEND script "\n            + ${text}")
endforeach()

file(WRITE "${OUT}" "// Made by src/golden/report/embed.cmake.
#include \"golden/report_page.hpp\"

namespace sr::golden {

ReportPage report_page() {
    return {${style},
            ${script}};
}

} // namespace sr::golden
")
