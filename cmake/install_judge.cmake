# Installs the judge beside core: the command graze, its corpus, schemas and pages, the adapter, and what
# find_package(graze COMPONENTS judge) reads. It can be moved as a whole: the command looks for its corpus beside itself.
if(NOT GRAZE_INSTALL)
  return()
endif()
include(GNUInstallDirs)
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
# As Debian has it: the text of MIT with a blank before each line, a dot for an empty one.
file(READ ${PROJECT_SOURCE_DIR}/LICENSE license_text)
string(STRIP "${license_text}" license_text)
string(REGEX REPLACE "\n\n" "\n.\n" license_text "${license_text}")
string(REPLACE "\n" "\n " license_text " ${license_text}")
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/copyright @ONLY CONTENT [[
Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: graze

Files: *
Copyright: 2026 the graze maintainers
License: MIT
Comment: The library, its headers, the adapter, the corpus, the schemas and the pages.

Files: usr/bin/graze
Copyright: 2026 the graze maintainers, and the authors of CGAL
License: GPL-3+
Comment: graze's own files in it are MIT, too. The program links CGAL's hulls and Nef polyhedra, which are GPL-3+, and may
 be passed on under the GPL only. On Debian its text is /usr/share/common-licenses/GPL-3. The pages that it writes hold
 three.js (MIT), Observable Plot (ISC) and D3 (ISC, BSD-3-Clause), each with its licence in the page.

License: MIT
@license_text@

License: GPL-3+
 /usr/share/common-licenses/GPL-3 on Debian, https://www.gnu.org/licenses/gpl-3.0.html elsewhere.
]])
install(FILES ${PROJECT_BINARY_DIR}/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})

if(PROJECT_IS_TOP_LEVEL)
  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGE_NAME graze)
  set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
  set(CPACK_PACKAGE_CONTACT "the graze maintainers")
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PACKAGE_SECTION devel)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libeigen3-dev (>= 3.4), cmake")
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "certified casts for convex shapes, and a judge of casts")
  set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
      "The library, its headers and the adapter for engines are MIT. The program graze links CGAL and is passed on under the GPL, version 3 or later."
  )
  include(CPack)
endif()
