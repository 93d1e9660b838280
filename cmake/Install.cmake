# cmake --install build --prefix DIR: the program, its image module, the CMake package, the schemas, the bundled scenes, the
# manual, and what desktops and shells read.
include(CMakePackageConfigHelpers)

install(TARGETS steradian EXPORT SteradianTargets RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
# Where src/image/codec.cpp looks. A folder less, and CPack takes it for a library of the linker's, for which the .deb runs ldconfig.
install(TARGETS sr_image_oiio LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/steradian/modules)

# In share/, find_package finds it before a language is enabled, too.
set(package_folder ${CMAKE_INSTALL_DATADIR}/cmake/Steradian)
install(EXPORT SteradianTargets NAMESPACE Steradian:: DESTINATION ${package_folder})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/SteradianConfigVersion.cmake COMPATIBILITY SameMinorVersion
                                 ARCH_INDEPENDENT)
install(FILES ${CMAKE_SOURCE_DIR}/cmake/SteradianConfig.cmake ${CMAKE_SOURCE_DIR}/cmake/SteradianGolden.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/SteradianConfigVersion.cmake
        DESTINATION ${package_folder})
install(DIRECTORY ${CMAKE_SOURCE_DIR}/assets/assignments DESTINATION ${CMAKE_INSTALL_DATADIR}/steradian)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/src/python/steradian/cluster DESTINATION ${CMAKE_INSTALL_DATADIR}/steradian
        FILES_MATCHING PATTERN *.py)
file(GLOB schemas CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/assets/*.schema.json)
install(FILES ${schemas} DESTINATION ${CMAKE_INSTALL_DATADIR}/steradian)
file(GLOB scenes CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/assets/scenes/*.gltf ${CMAKE_SOURCE_DIR}/assets/scenes/*.ies)
install(FILES ${scenes} ${CMAKE_SOURCE_DIR}/assets/scenes/README.md DESTINATION ${CMAKE_INSTALL_DATADIR}/steradian/scenes)
install(FILES ${CMAKE_SOURCE_DIR}/README.md ${CMAKE_SOURCE_DIR}/CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright) # Debian's name for it

# Desktops: an icon, and that steradian opens .gltf and .glb files.
install(FILES ${CMAKE_SOURCE_DIR}/assets/desktop/steradian.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES ${CMAKE_SOURCE_DIR}/assets/desktop/steradian.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${CMAKE_SOURCE_DIR}/assets/desktop/steradian.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)

install(CODE "set(program \"$<TARGET_FILE:steradian>\")
              set(doc_folder \"${CMAKE_INSTALL_DOCDIR}\")
              set(version \"${PROJECT_VERSION}\")
              set(contact \"${CPACK_PACKAGE_CONTACT}\")")
install(SCRIPT ${CMAKE_SOURCE_DIR}/cmake/InstallTexts.cmake)
