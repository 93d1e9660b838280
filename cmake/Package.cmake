# cpack -G DEB and cpack -G TGZ, in the build folder. dpkg-shlibdeps names the libraries that the package depends on.
set(CPACK_PACKAGE_NAME steradian)
set(CPACK_PACKAGE_VENDOR "Steradian developers")
set(CPACK_PACKAGE_CONTACT "Steradian developers <developers@steradian.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "renderer for direct illumination in physical units")
set(CPACK_PACKAGE_DESCRIPTION
    "Steradian renders glTF scenes under their own lights by OpenGL, with or
without a GPU or a display. Every pixel is a radiance in cd/m², and can be
checked against the equation that it evaluates. It also compares pictures,
runs suites of golden images, and has a course in which students write the
terms of the equation in GLSL.")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
                                                WORLD_EXECUTE)
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl1, libgl1-mesa-dri") # opened at run time, so that dpkg-shlibdeps does not see them
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "fonts-dejavu-core") # letters of the viewer's panels
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "openimageio-tools, libosmesa6")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
include(CPack)
