# find_package(Steradian): the program as the target Steradian::steradian, and steradian_add_golden_test().
include("${CMAKE_CURRENT_LIST_DIR}/SteradianTargets.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/SteradianGolden.cmake")
