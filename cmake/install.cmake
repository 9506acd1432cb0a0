# Installs core: headers, the compiled library, the targets graze::core and graze::graze, and what
# find_package(graze) reads.
#
#   cmake -S . -B build/core -DGRAZE_TOOLS=OFF -DGRAZE_TESTS=OFF && cmake --build build/core
#   cmake --install build/core --prefix DIR
#
# needs Eigen alone. With -DGRAZE_LIBRARY=OFF there is nothing to build, and only graze::core to install. As a subproject graze installs nothing, unless GRAZE_INSTALL says so: then Eigen must come from
# find_package in the superproject too.
option(GRAZE_INSTALL "Install the headers of core and its package files" ${PROJECT_IS_TOP_LEVEL})
if(NOT GRAZE_INSTALL)
  return()
endif()

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# Headers alone depend on no architecture, and neither does their package: it lives under share/, and its version file
# does not compare pointer sizes.
if(GRAZE_LIBRARY)
  set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/graze)
  set(installed_targets graze_core graze)
  set(any_architecture)
else()
  set(package_directory ${CMAKE_INSTALL_DATADIR}/cmake/graze)
  set(installed_targets graze_core)
  set(any_architecture ARCH_INDEPENDENT)
endif()
install(
  DIRECTORY ${PROJECT_SOURCE_DIR}/core/graze
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING
  PATTERN "*.hpp")
install(TARGETS ${installed_targets} EXPORT graze_targets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(
  EXPORT graze_targets
  FILE graze-targets.cmake
  NAMESPACE graze::
  DESTINATION ${package_directory})

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/graze-config.cmake.in
                              ${PROJECT_BINARY_DIR}/cmake/graze-config.cmake INSTALL_DESTINATION ${package_directory})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cmake/graze-config-version.cmake
                                 COMPATIBILITY SameMajorVersion ${any_architecture})
install(FILES ${PROJECT_BINARY_DIR}/cmake/graze-config.cmake ${PROJECT_BINARY_DIR}/cmake/graze-config-version.cmake
        DESTINATION ${package_directory})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
