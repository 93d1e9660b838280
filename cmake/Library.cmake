# sr_library(NAME SOURCES ... LINKS ...): the library of one folder of src/, and its floor.
#
# LINKS is the folder's whole view of the world: a folder may include only what it links, which the test
# unit.house.floors checks by reading the #include lines.
function(sr_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(sr_${name} STATIC ${arg_SOURCES})
  target_include_directories(sr_${name} PUBLIC ${CMAKE_SOURCE_DIR}/src)
  target_link_libraries(sr_${name} PUBLIC ${arg_LINKS} PRIVATE sr_compile_settings ${arg_PRIVATE_LINKS})
endfunction()
