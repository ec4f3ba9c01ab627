# Run by CPack on the installed tree before it becomes a package: Debian's names and compression of what every package has.
set(docs ${CPACK_TEMPORARY_DIRECTORY}/usr/share/doc/vvr)
set(ENV{SOURCE_DATE_EPOCH} ${CPACK_VVR_EPOCH})

# The license is the file `copyright`, in Debian's form.
file(READ ${docs}/LICENSE license)
file(REMOVE ${docs}/LICENSE)
string(REGEX MATCH "Copyright \\(c\\) ([^\n]*)" ignored "${license}")
set(holder ${CMAKE_MATCH_1})
string(REGEX REPLACE "^.*Copyright[^\n]*\n+" "" license "${license}")
string(STRIP "${license}" license)
string(REPLACE "\n\n" "\n.\n" license "${license}")
string(REPLACE "\n" "\n " license "${license}")
file(WRITE ${docs}/copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: vvr

Files: *
Copyright: ${holder}
License: BSD-3-Clause
 ${license}
")

string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${docs}/changelog.Debian
"vvr (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * changelog.gz says what is new in this version.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
file(RENAME ${docs}/CHANGELOG.md ${docs}/changelog)
file(GLOB compressed ${docs}/changelog ${docs}/changelog.Debian ${CPACK_TEMPORARY_DIRECTORY}/usr/share/man/man1/*)
execute_process(COMMAND gzip -9n ${compressed} COMMAND_ERROR_IS_FATAL ANY)

# What the package is made of, last: it has the sums of all other files.
execute_process(COMMAND ${CPACK_VVR_PYTHON} ${CPACK_VVR_SOURCES}/scripts/sbom ${CPACK_TEMPORARY_DIRECTORY}
    ${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE} ${CPACK_VVR_EPOCH}
  OUTPUT_FILE ${docs}/vvr.spdx.json COMMAND_ERROR_IS_FATAL ANY)
