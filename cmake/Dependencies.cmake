# Finds every dependency, and names all the missing ones in a single message with the line that installs them.
find_package(PkgConfig QUIET)
set(missing_packages "")

macro(require_package debian_name condition)
  if(NOT ${condition})
    list(APPEND missing_packages ${debian_name})
  endif()
endmacro()

find_package(Threads QUIET)
find_package(ZLIB QUIET)
require_package(zlib1g-dev ZLIB_FOUND)
find_package(glm QUIET CONFIG)
require_package(libglm-dev glm_FOUND)
find_package(fmt QUIET CONFIG)
require_package(libfmt-dev fmt_FOUND)
find_package(nlohmann_json QUIET CONFIG)
require_package(nlohmann-json3-dev nlohmann_json_FOUND)
find_package(OpenImageIO QUIET CONFIG)
require_package(libopenimageio-dev OpenImageIO_FOUND)
find_package(glfw3 QUIET CONFIG)
require_package(libglfw3-dev glfw3_FOUND)
find_package(embree 3 QUIET CONFIG)
require_package(libembree-dev embree_FOUND)
find_package(CLI11 QUIET CONFIG)
require_package(libcli11-dev CLI11_FOUND)

# tinygltf's upstream is one header; Debian's library is not used, so that our flags (sanitizers, no stb) reach it.
find_path(TINYGLTF_INCLUDE_DIR tiny_gltf.h)
require_package(libtinygltf-dev TINYGLTF_INCLUDE_DIR)
# Headers only: the drivers behind them are opened at run time (src/gl/).
find_path(EGL_INCLUDE_DIR EGL/egl.h)
if(UNIX AND NOT APPLE)
  require_package(libegl-dev EGL_INCLUDE_DIR)
endif()

# Compressed glTF meshes: left out, and said so, where the libraries are not.
find_package(meshoptimizer QUIET CONFIG)
find_package(draco QUIET CONFIG)
foreach(pair "meshoptimizer EXT_meshopt_compression" "draco KHR_draco_mesh_compression")
  string(REPLACE " " ";" pair "${pair}")
  list(GET pair 0 library)
  list(GET pair 1 extension)
  if(NOT ${library}_FOUND)
    message(STATUS "glTF's ${extension} will not be read. To read it: sudo apt-get install lib${library}-dev")
  endif()
endforeach()

if(BUILD_TESTING OR NOT DEFINED BUILD_TESTING)
  find_package(GTest QUIET)
  require_package(libgtest-dev GTest_FOUND)
  find_program(GLSLANG_VALIDATOR glslangValidator)
  require_package(glslang-tools GLSLANG_VALIDATOR)
endif()

# The OpenGL loader is generated (glad 2, a Python package): exactly 4.1 core and KHR_debug.
find_package(Python3 QUIET COMPONENTS Interpreter)
find_program(GLAD_PROGRAM glad HINTS ${CMAKE_SOURCE_DIR}/.venv/bin ENV GLAD_ROOT)
if(NOT GLAD_PROGRAM)
  set(glad_hint "\n    python3 -m venv .venv && .venv/bin/pip install -r tools/requirements.txt")
endif()

if(missing_packages OR NOT GLAD_PROGRAM)
  set(install_hint "")
  if(missing_packages)
    list(JOIN missing_packages " " missing_line)
    set(install_hint "\n    sudo apt-get install ${missing_line}")
  endif()
  message(FATAL_ERROR "Steradian needs what this machine lacks. Run tools/setup, or install it yourself:"
                      "${install_hint}${glad_hint}\n"
                      "(Debian and Ubuntu names; tools/setup --help says what to do on other systems.)")
endif()
