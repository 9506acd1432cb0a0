# Installs core: headers, the compiled library, the targets graze::core and graze::graze, and what
# find_package(graze) reads.
#
#   cmake -S . -B build/core -DGRAZE_TOOLS=OFF -DGRAZE_TESTS=OFF && cmake --build build/core
#   cmake --install build/core --prefix DIR
#
# needs Eigen alone. With -DGRAZE_LIBRARY=OFF there is nothing to build, and only graze::core to install. As a subproject
# graze installs nothing, unless GRAZE_INSTALL says so: then Eigen must come from find_package in the superproject too.
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

# graze_pkgconfig(name DESCRIPTION d REQUIRES r CFLAGS c LIBS l): installs name.pc.
function(graze_pkgconfig pc_name)
  cmake_parse_arguments(pc "" "DESCRIPTION;REQUIRES;CFLAGS;LIBS" "" ${ARGN})
  foreach(part IN ITEMS description requires cflags libs)
    string(TOUPPER ${part} upper)
    set(pc_${part} "${pc_${upper}}")
  endforeach()
  if(GRAZE_LIBRARY)
    set(directory ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
  else()
    set(directory ${CMAKE_INSTALL_DATADIR}/pkgconfig)
  endif()
  file(RELATIVE_PATH pc_prefix /prefix/${directory} /prefix)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/pkgconfig.pc.in ${PROJECT_BINARY_DIR}/${pc_name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${pc_name}.pc DESTINATION ${directory})
endfunction()
graze_pkgconfig(graze-core DESCRIPTION "Certified casts for convex shapes, header-only" REQUIRES "eigen3 >= 3.4")
if(GRAZE_LIBRARY)
  graze_pkgconfig(
    graze
    DESCRIPTION "Certified casts for convex shapes, compiled for float and double"
    REQUIRES "eigen3 >= 3.4"
    CFLAGS -DGRAZE_COMPILED
    LIBS "-L\${libdir} -lgraze")
  if(GRAZE_SCENE)
    graze_pkgconfig(
      graze-scene
      DESCRIPTION "Many bodies, rays and casts over one step"
      REQUIRES graze
      LIBS "-L\${libdir} -lgraze_scene -pthread")
  endif()
endif()

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/graze-config.cmake.in
                              ${PROJECT_BINARY_DIR}/cmake/graze-config.cmake INSTALL_DESTINATION ${package_directory})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cmake/graze-config-version.cmake
                                 COMPATIBILITY SameMajorVersion ${any_architecture})
install(FILES ${PROJECT_BINARY_DIR}/cmake/graze-config.cmake ${PROJECT_BINARY_DIR}/cmake/graze-config-version.cmake
        DESTINATION ${package_directory})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT licence)
