# What every exported folder gets. A new or removed plugin makes CMake run again.
if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(watched CONFIGURE_DEPENDS)
endif()
set(here ${CMAKE_CURRENT_LIST_DIR})
file(GLOB plugin_names RELATIVE ${here} ${watched} ${here}/README.md ${here}/render.py ${here}/steradian_mitsuba/*.py)
