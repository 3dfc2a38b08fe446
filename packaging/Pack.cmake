# cpack makes a .deb, which names the packages that it needs, and a .tar.gz, which holds their libraries.
set(CPACK_PACKAGE_NAME tissuetessellation)
set(CPACK_PACKAGE_VENDOR "The TissueTessellation contributors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Triangular meshes of all cell walls of a living tissue from a 3-D image")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_RESOURCE_FILE_README ${PROJECT_SOURCE_DIR}/README.md)
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The TissueTessellation contributors")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
  "libinsighttoolkit5-dev, libvtk9-dev, libcgal-dev, libtiff-dev, libexpat1-dev, libegl-dev, xvfb, xauth")
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY ON)
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/packaging/PackComponents.cmake)

# All libraries but those of the C library, which are the system's. A bare system has no C++ library either.
if(TissueTessellation_BUILD_APPS AND CMAKE_VERSION VERSION_GREATER_EQUAL 3.21)
  install(RUNTIME_DEPENDENCY_SET TissueTessellationLibraries COMPONENT Libraries EXCLUDE_FROM_ALL
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/tissuetessellation
    PRE_EXCLUDE_REGEXES "^ld-linux" "^lib(c|m|dl|rt|pthread|resolv|util)[.]so" "^libTissueTessellation"
    DIRECTORIES ${CMAKE_INSTALL_FULL_LIBDIR})
endif()
include(CPack)
