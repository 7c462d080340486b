# `cpack -G DEB` in the build folder: photic_VERSION_ARCHITECTURE.deb, for /usr.
set(CPACK_PACKAGE_NAME photic)
set(CPACK_PACKAGE_VENDOR "The Photic developers")
set(CPACK_PACKAGE_CONTACT "The Photic developers")  # the authors of CITATION.cff
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulator of oceanographic lidar")
set(CPACK_STRIP_FILES ON)
# Without the library for other programs.
set(CPACK_INSTALL_CMAKE_PROJECTS ${PROJECT_BINARY_DIR} photic Unspecified /)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
    "Photic simulates what a lidar over or in the sea will see: echoes resolved
by range, elastic, Raman-shifted and fluorescent, with multiple scattering
and a real telescope, and an error bar on every number. Scenes are TOML files,
results netCDF files; the Python package photic runs, reads and draws them.")
# The libraries of the program by dpkg-shlibdeps. `import photic` must work where the package is; only drawing needs matplotlib.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3, python3-netcdf4, python3-numpy, python3-xarray")
if(TARGET photic_python)  # which is for one version of Python
  get_target_property(version photic_python PHOTIC_PYTHON_VERSION)
  math(EXPR next "${version} + 1")
  string(PREPEND CPACK_DEBIAN_PACKAGE_DEPENDS "python3 (>= 3.${version}), python3 (<< 3.${next}), ")
endif()
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-matplotlib")
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
# They compile the Python package where it is installed, and take away what was compiled.
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/debian/postinst ${PROJECT_SOURCE_DIR}/cmake/debian/prerm)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/finish.cmake)
include(CPack)
