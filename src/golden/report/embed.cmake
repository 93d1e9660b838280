# cmake -DROOT=report -DFUNCTION=sr::golden::report_base -DHEADER=golden/page.hpp -DOUT=report_base.cpp -P embed.cmake: the style and the
# scripts of a folder as a C++ file that defines the function, which returns a sr::golden::ReportPage.
function(raw_string file out)
  file(READ "${file}" text)
  string(FIND "${text}" ")__page__\"" end_mark)
  if(NOT end_mark EQUAL -1)
    message(FATAL_ERROR "${file}: contains )__page__\", which ends a raw string: write it otherwise")
  endif()
  set(${out} "R\"__page__(${text})__page__\"" PARENT_SCOPE)
endfunction()

set(style "std::string()")
set(script "std::string()")
file(GLOB files "${ROOT}/*.css" "${ROOT}/*.js")
list(SORT files)
foreach(file IN LISTS files)
  raw_string("${file}" text)
  if(file MATCHES "css$")
    string(APPEND style "\n            + ${text}")
  else()
    string(APPEND script "\n            + ${text}")
  endif()
endforeach()

file(WRITE "${OUT}" "// Made by src/golden/report/embed.cmake.
#include \"${HEADER}\"

sr::golden::ReportPage ${FUNCTION}() {
    return {${style},
            ${script}};
}
")
