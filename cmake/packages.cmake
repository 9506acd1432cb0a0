# Makes two Debian packages: libgraze-dev, the library (MIT), and graze, the command (GPL, because it links CGAL).
# `./run deb` builds them, and `./run deb --try` installs them in a fresh system.
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL library command)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_NAME graze)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "the graze maintainers")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libgraze-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4)")
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "The library and its headers return a proved bracket around the time at which
two moving convex shapes first touch.")
set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME graze)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SUGGESTS "libgraze-dev, cmake")
set(CPACK_DEBIAN_COMMAND_DESCRIPTION "The command judges casts: graze's methods, or the engine of somebody else.
Its own files are MIT. It links CGAL, so it is passed on under the
GPL, version 3 or later.")

# The format of a copyright file: a blank before each line, and a dot in an empty one.
file(READ ${PROJECT_SOURCE_DIR}/LICENSE license)
string(STRIP "${license}" license)
string(REGEX REPLACE "\n\n" "\n.\n" license "${license}")
string(REPLACE "\n" "\n " license "License: MIT\n ${license}")
set(library_copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: graze

Files: *
Copyright: 2026 the graze maintainers
License: MIT
")
set(command_copyright "${library_copyright}Comment: The adapter, the corpus, the schemas and the pages.

Files: usr/bin/graze
Copyright: 2026 the graze maintainers, and the authors of CGAL
License: GPL-3+
Comment: graze's own files in it are MIT, too. The program links CGAL's hulls and Nef polyhedra, which are GPL-3+, and may
 be passed on under the GPL only. On Debian its text is /usr/share/common-licenses/GPL-3. The pages that it writes hold
 three.js (MIT), Observable Plot (ISC) and D3 (ISC, BSD-3-Clause), each with its licence in the page.

License: GPL-3+
 /usr/share/common-licenses/GPL-3 on Debian, https://www.gnu.org/licenses/gpl-3.0.html elsewhere.
")

# The files that Debian requires of each package. Only the command's copyright is in other installations, too.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(component IN ITEMS library command)
  string(TOUPPER ${component} upper)
  set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(made ${PROJECT_BINARY_DIR}/debian/${package})
  file(WRITE ${made}/copyright "${${component}_copyright}\n${license}\n")
  file(WRITE ${made}/changelog.Debian "${package} (${PROJECT_VERSION}-1) stable; urgency=medium

  * Release ${PROJECT_VERSION}.

 -- ${CPACK_PACKAGE_CONTACT} <>  ${date}
")
  file(WRITE ${made}/overrides "# Reports go to the repository. There is no address yet.
${package}: malformed-contact
${package}: bogus-mail-host-in-debian-changelog
")
  install(CODE "execute_process(COMMAND gzip -9nfk ${made}/changelog.Debian)" COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES ${made}/changelog.Debian.gz DESTINATION share/doc/${package} COMPONENT ${component}
          EXCLUDE_FROM_ALL)
  install(FILES ${made}/overrides DESTINATION share/lintian/overrides RENAME ${package} COMPONENT ${component}
          EXCLUDE_FROM_ALL)
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/debian/libgraze-dev/copyright DESTINATION share/doc/libgraze-dev COMPONENT library
        EXCLUDE_FROM_ALL)
install(FILES ${PROJECT_BINARY_DIR}/debian/graze/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT command)

# The manual page is the help of the command.
install(CODE "set(page ${PROJECT_BINARY_DIR}/debian/graze/graze.1)" COMPONENT command EXCLUDE_FROM_ALL)
install(CODE [[
  execute_process(COMMAND $<TARGET_FILE:graze_command> --help OUTPUT_VARIABLE help)
  string(REPLACE "-" "\\-" help "${help}")
  file(WRITE ${page} ".TH GRAZE 1\n.SH NAME\ngraze \\- certified casts for convex shapes\n.SH DESCRIPTION\n.nf\n${help}")
  execute_process(COMMAND gzip -9nf ${page})
]] COMPONENT command EXCLUDE_FROM_ALL)
install(FILES ${PROJECT_BINARY_DIR}/debian/graze/graze.1.gz DESTINATION share/man/man1 COMPONENT command EXCLUDE_FROM_ALL)
include(CPack)
