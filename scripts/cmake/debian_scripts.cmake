# Run by CPack on the package it has made: takes out the scripts that CPack adds. They run ldconfig, for a library that only
# vvr loads, and with a postrm `dpkg -r` would leave a trace of the package. What depends on the machine or the moment goes
# too: the umask, the order of a folder, dates.
foreach(package IN LISTS CPACK_PACKAGE_FILES)
  set(tree ${CPACK_TOPLEVEL_DIRECTORY}/rebuilt)
  file(REMOVE_RECURSE ${tree})
  set(ENV{SOURCE_DATE_EPOCH} ${CPACK_VVR_EPOCH})
  execute_process(COMMAND dpkg-deb --raw-extract ${package} ${tree} COMMAND_ERROR_IS_FATAL ANY)
  file(REMOVE ${tree}/DEBIAN/postinst ${tree}/DEBIAN/postrm)
  set(ENV{LC_ALL} C)
  execute_process(COMMAND sort -k 2 -o ${tree}/DEBIAN/md5sums ${tree}/DEBIAN/md5sums COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND chmod -R u=rwX,go=rX ${tree} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND find ${tree} -exec touch --no-dereference --date=@${CPACK_VVR_EPOCH} {} + COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND dpkg-deb --root-owner-group -Zxz --build ${tree} ${package} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  file(REMOVE_RECURSE ${tree})
endforeach()
