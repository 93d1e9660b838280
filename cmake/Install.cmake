# cmake --install build --prefix DIR: the program, its image module beside it, and the CMake package.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS steradian EXPORT SteradianTargets RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS sr_image_oiio LIBRARY DESTINATION ${CMAKE_INSTALL_BINDIR}) # where src/image/codec.cpp looks

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Steradian)
install(EXPORT SteradianTargets NAMESPACE Steradian:: DESTINATION ${package_folder})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/SteradianConfigVersion.cmake COMPATIBILITY SameMinorVersion
                                 ARCH_INDEPENDENT)
install(FILES ${CMAKE_SOURCE_DIR}/cmake/SteradianConfig.cmake ${CMAKE_SOURCE_DIR}/cmake/SteradianGolden.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/SteradianConfigVersion.cmake
        DESTINATION ${package_folder})
install(FILES ${CMAKE_SOURCE_DIR}/assets/golden_suite.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/steradian)
