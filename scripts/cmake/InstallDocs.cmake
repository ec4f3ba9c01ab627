# What is installed beside the program: its pages without their pictures, and its services.
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
  ${PROJECT_SOURCE_DIR}/CITATION.cff ${PROJECT_SOURCE_DIR}/CONTRIBUTING.md ${PROJECT_SOURCE_DIR}/SECURITY.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN figures EXCLUDE)

# The examples name the program as `make install` does; here they get the folder that it really is in.
install(CODE "
  foreach(unit vvr-archive.service vvr-archive.timer vvr-watch@.service)
    file(READ \"${PROJECT_SOURCE_DIR}/docs/examples/\${unit}\" text)
    string(REGEX REPLACE \"^(#[^\\n]*\\n)+\" \"\" text \"\${text}\")
    string(REPLACE /usr/local/bin/vvr \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_BINDIR}/vvr\" text \"\${text}\")
    set(installed \"\${CMAKE_INSTALL_PREFIX}/lib/systemd/system/\${unit}\")
    file(WRITE \"\$ENV{DESTDIR}\${installed}\" \"\${text}\")
    list(APPEND CMAKE_INSTALL_MANIFEST_FILES \"\${installed}\")
  endforeach()
")
# The user of the services; `systemd-sysusers` makes it.
file(CONFIGURE OUTPUT sysusers.conf CONTENT "u vvr - \"Pictures of surveillance video\" /var/lib/vvr\n")
install(FILES ${PROJECT_BINARY_DIR}/sysusers.conf DESTINATION lib/sysusers.d RENAME vvr.conf)
