# Installs core, and nothing else: headers, the target graze::core, and what find_package(graze) reads.
#
#   cmake -S . -B build/core -DGRAZE_TOOLS=OFF -DGRAZE_TESTS=OFF && cmake --install build/core --prefix DIR
#
# needs Eigen alone. As a subproject graze installs nothing, unless GRAZE_INSTALL says so: then Eigen must come from
# find_package in the superproject too.
option(GRAZE_INSTALL "Install the headers of core and its package files" ${PROJECT_IS_TOP_LEVEL})
if(NOT GRAZE_INSTALL)
  return()
endif()

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# Headers depend on no architecture, so neither does the package: it lives under share/, and its version file does not
# compare pointer sizes.
set(package_directory ${CMAKE_INSTALL_DATADIR}/cmake/graze)
install(
  DIRECTORY ${PROJECT_SOURCE_DIR}/core/graze
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING
  PATTERN "*.hpp")
install(TARGETS graze_core EXPORT graze_targets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(
  EXPORT graze_targets
  FILE graze-targets.cmake
  NAMESPACE graze::
  DESTINATION ${package_directory})

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/graze-config.cmake.in
                              ${PROJECT_BINARY_DIR}/cmake/graze-config.cmake INSTALL_DESTINATION ${package_directory})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cmake/graze-config-version.cmake
                                 COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/cmake/graze-config.cmake ${PROJECT_BINARY_DIR}/cmake/graze-config-version.cmake
        DESTINATION ${package_directory})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
