# cmake -DROOT=shaders -DOUT=embedded.cpp -P embed.cmake: the sources below ROOT as a C++ file that defines
# sr::glsl::embedded().
file(GLOB_RECURSE names RELATIVE "${ROOT}" "${ROOT}/*.glsl" "${ROOT}/*.vert" "${ROOT}/*.frag")
list(SORT names)

set(entries "")
foreach(name IN LISTS names)
  file(READ "${ROOT}/${name}" text)
  string(FIND "${text}" ")__glsl__\"" end_mark)
  if(NOT end_mark EQUAL -1)
    message(FATAL_ERROR "${ROOT}/${name}: contains )__glsl__\", which ends a raw string: write it otherwise")
  endif()
  string(APPEND entries "        {R\"__glsl__(${name})__glsl__\", R\"__glsl__(${text})__glsl__\"},\n")
endforeach()

file(WRITE "${OUT}" "// Made by src/glsl/embed.cmake.
#include \"glsl/root.hpp\"

namespace sr::glsl {

Root embedded() {
    static const Root shaders = Root::memory(\"shaders\", Files{
${entries}    });
    return shaders;
}

} // namespace sr::glsl
")
