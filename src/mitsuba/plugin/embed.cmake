# cmake -DROOT=plugin -DOUT=plugin_files.cpp -P embed.cmake: the files that go into every exported folder, as a C++ file
# that defines sr::mitsuba::plugin_files().
include("${ROOT}/files.cmake")
set(entries "")
foreach(name ${plugin_names})
  file(READ "${ROOT}/${name}" text)
  string(FIND "${text}" ")__file__\"" end_mark)
  if(NOT end_mark EQUAL -1)
    message(FATAL_ERROR "${ROOT}/${name}: contains )__file__\", which ends a raw string: write it otherwise")
  endif()
  string(APPEND entries "        {\"${name}\", R\"__file__(${text})__file__\"},\n")
endforeach()

file(WRITE "${OUT}" "// Made by src/mitsuba/plugin/embed.cmake.
#include \"mitsuba/plugin_files.hpp\"

namespace sr::mitsuba {

std::vector<PluginFile> plugin_files() {
    return {
${entries}    };
}

} // namespace sr::mitsuba
")
