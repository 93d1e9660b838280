# Language, warnings and sanitizers, the same for every target of ours.
if((CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 11)
   OR (CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 16))
  message(FATAL_ERROR "Steradian needs GCC 11 or Clang 16, or later, for C++20; ${CMAKE_CXX_COMPILER} is ${CMAKE_CXX_COMPILER_ID} "
                      "${CMAKE_CXX_COMPILER_VERSION}: choose another by cmake -DCMAKE_CXX_COMPILER=…")
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)
endif()

option(STERADIAN_SANITIZE "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
option(STERADIAN_WERROR "Treat warnings as errors" OFF)

add_library(sr_compile_settings INTERFACE)
if(MSVC)
  target_compile_options(sr_compile_settings INTERFACE /W4 /utf-8)
else()
  target_compile_options(sr_compile_settings INTERFACE -Wall -Wextra -Wpedantic
                                               # Of files that are compiled together, what is local to one shadows nothing of another's.
                                               $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local> -Wconversion -Wno-sign-conversion
                                               $<$<BOOL:${STERADIAN_WERROR}>:-Werror>
                                               # GCC 12 warns of its own std::string (GCC bug 105651).
                                               $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
endif()
if(STERADIAN_SANITIZE)
  target_compile_options(sr_compile_settings INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined
                                               -fno-omit-frame-pointer)
  # UndefinedBehaviorSanitizer describes each checked place by data with pointers, some 5 million of them in the program. In a
  # program at a fixed address the linker fills them in; otherwise each start does, and touches 100 MB.
  target_link_options(sr_compile_settings INTERFACE -fsanitize=address,undefined
                                                    $<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:-no-pie>)
endif()

# Files compiled together share headers and the templates that they use. 32 files at a time take four fifths of the processor time
# of eight at a time, and 1.7 GB of memory. Where there are cores enough, what counts is that all of them have work.
if(CMAKE_UNITY_BUILD AND NOT CMAKE_UNITY_BUILD_BATCH_SIZE)
  cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
  if(cores LESS_EQUAL 4)
    set(CMAKE_UNITY_BUILD_BATCH_SIZE 32)
  else()
    set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)
  endif()
endif()

# What runs once or waits for others need not be fast. -O1 takes a quarter off the time that templates compile; with
# sanitizers -O0 halves it. A fifth of the rest, and half of the code, is a check of each pointer for null and for its alignment.
# AddressSanitizer reports what reads from null. What reads bytes of files (src/gltf, src/image, src/scene) keeps both checks.
add_library(sr_compile_quickly INTERFACE)
if(NOT MSVC AND NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
  if(STERADIAN_SANITIZE)
    target_compile_options(sr_compile_quickly INTERFACE -O0 -fno-sanitize=null,alignment)
  else()
    target_compile_options(sr_compile_quickly INTERFACE -O1)
  endif()
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()
