# Writes OUTPUT, a header with the commit of SOURCE, if it says something new: only what includes it is compiled again.
#   cmake -DSOURCE=DIR -DOUTPUT=FILE -P Commit.cmake
execute_process(COMMAND git -C ${SOURCE} rev-parse --short=12 HEAD
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  set(commit "")
endif()
set(text "#pragma once\n// The commit that this was built from; empty outside a git checkout.\n#define STERADIAN_COMMIT \"${commit}\"\n")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} old_text)
endif()
if(NOT "${old_text}" STREQUAL "${text}")
  file(WRITE ${OUTPUT} "${text}")
endif()
