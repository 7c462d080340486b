# What `cmake --install` puts under a prefix. The program finds its data, and `photic plot` the Python package, relative to itself.
# apps/photic installs the program and its manual.

set(share ${CMAKE_INSTALL_DATADIR}/photic)
install(DIRECTORY data/ DESTINATION ${share}/data FILES_MATCHING PATTERN "*.csv" PATTERN "README.md" PATTERN "reference" EXCLUDE)
install(DIRECTORY ${PROJECT_BINARY_DIR}/scenes/ DESTINATION ${share}/scenes)

# Debian's path of Python packages under the prefix /usr. The metadata give Python the version, of which project() in CMakeLists.txt is
# the one place.
set(packages lib/python3/dist-packages)
set(metadata photic-${PROJECT_VERSION}.dist-info)
install(DIRECTORY python/photic DESTINATION ${packages}
        FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)
# By the module the package simulates, with the data and the starters' files beside it.
if(TARGET photic_python)
  install(TARGETS photic_python LIBRARY DESTINATION ${packages}/photic)
endif()
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/linked/package)
foreach(folder data scenes)
  file(CREATE_LINK ../../../../${share}/${folder} ${PROJECT_BINARY_DIR}/linked/package/${folder} SYMBOLIC)
  install(FILES ${PROJECT_BINARY_DIR}/linked/package/${folder} DESTINATION ${packages}/photic)
endforeach()
configure_file(cmake/METADATA.in ${PROJECT_BINARY_DIR}/${metadata}/METADATA @ONLY)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/${metadata}/INSTALLER CONTENT "cmake\n")
install(DIRECTORY ${PROJECT_BINARY_DIR}/${metadata} DESTINATION ${packages})

# A library for other programs: find_package(photic), photic::photic. Not in the Debian package (cmake/package.cmake).
include(cmake/headers.cmake)
include(CMakePackageConfigHelpers)
get_property(libraries GLOBAL PROPERTY PHOTIC_LIBRARIES)
add_library(photic_library INTERFACE)
set_target_properties(photic_library PROPERTIES EXPORT_NAME photic)
target_link_libraries(photic_library INTERFACE photic_session)
target_compile_features(photic_library INTERFACE cxx_std_20)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/photic)
install(TARGETS ${libraries} photic_flags photic_library EXPORT photicTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/photic COMPONENT development)
install(EXPORT photicTargets NAMESPACE photic:: DESTINATION ${package} COMPONENT development)
configure_file(cmake/photicConfig.cmake.in ${PROJECT_BINARY_DIR}/package/photicConfig.cmake COPYONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/photicConfigVersion.cmake COMPATIBILITY ExactVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/photicConfig.cmake ${PROJECT_BINARY_DIR}/package/photicConfigVersion.cmake
        DESTINATION ${package} COMPONENT development)
photic_public_headers(headers scene/scene.hpp scene/read.hpp session/*.hpp tally/result.hpp io/*.hpp)
foreach(header IN LISTS headers)
  cmake_path(GET header PARENT_PATH folder)
  install(FILES src/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/photic/${folder} COMPONENT development)
endforeach()

# Where each shell looks; zsh of Debian packages has another place (cmake/debian/finish.cmake).
install(FILES completions/photic.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME photic)
install(FILES completions/_photic DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES completions/photic.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

# Laid out as in the source tree, so that links from page to page lead somewhere; those into the source do not.
install(FILES LICENSE README.md CHANGELOG.md CONTRIBUTING.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/linked)
foreach(folder data scenes)
  file(CREATE_LINK ../../photic/${folder} ${PROJECT_BINARY_DIR}/linked/${folder} SYMBOLIC)
  install(FILES ${PROJECT_BINARY_DIR}/linked/${folder} DESTINATION ${CMAKE_INSTALL_DOCDIR})
endforeach()
