# Installs the judge beside core: the command graze, its corpus, schemas and pages, the adapter, and what
# find_package(graze COMPONENTS judge) reads. It can be moved as a whole: the command looks for its corpus beside itself.
if(NOT GRAZE_INSTALL)
  return()
endif()
include(GNUInstallDirs)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME command)
# Beside core's package files (cmake/install.cmake).
if(GRAZE_LIBRARY)
  set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/graze)
else()
  set(package_directory ${CMAKE_INSTALL_DATADIR}/cmake/graze)
endif()
set_target_properties(graze_command PROPERTIES EXPORT_NAME command)
install(TARGETS graze_command graze_adapter EXPORT graze_judge_targets
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(
  EXPORT graze_judge_targets
  FILE graze-judge-targets.cmake
  NAMESPACE graze::
  DESTINATION ${package_directory})
install(FILES ${PROJECT_SOURCE_DIR}/cmake/graze-certify.cmake DESTINATION ${package_directory})
install(FILES ${PROJECT_SOURCE_DIR}/engines/adapter/graze_adapter.hpp ${PROJECT_SOURCE_DIR}/engines/adapter/graze_engine.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(
  DIRECTORY ${PROJECT_SOURCE_DIR}/corpus/cases
  DESTINATION ${CMAKE_INSTALL_DATADIR}/graze/corpus
  FILES_MATCHING
  PATTERN "*.json"
  PATTERN "*.jsonl")
install(FILES ${PROJECT_SOURCE_DIR}/corpus/flags.json ${PROJECT_SOURCE_DIR}/corpus/known_failures.jsonl
        DESTINATION ${CMAKE_INSTALL_DATADIR}/graze/corpus)
if(EXISTS ${PROJECT_SOURCE_DIR}/docs/schemas)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/schemas DESTINATION ${CMAKE_INSTALL_DATADIR}/graze)
endif()
install(FILES ${PROJECT_SOURCE_DIR}/docs/reference/protocol.md ${PROJECT_SOURCE_DIR}/docs/reference/case-format.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/engines/adapter/templates DESTINATION ${CMAKE_INSTALL_DATADIR}/graze)
