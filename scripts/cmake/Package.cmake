# The Debian package; scripts/package makes it.
# Who answers for the package, as Debian's own tools have it.
set(CPACK_PACKAGE_CONTACT "The vvr authors <vvr@example.org>")
if(DEFINED ENV{DEBEMAIL} AND DEFINED ENV{DEBFULLNAME})
  set(CPACK_PACKAGE_CONTACT "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME vvr)
set(CPACK_PACKAGE_VERSION ${VVR_DEBIAN_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "surveillance video as one still picture")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Turns hours of surveillance video into one still picture that a person reads
at a glance: who came, where they stayed, what they left behind, which way
they went, and when. The video volume is bent into a horseshoe and drawn with
OpenGL, on a graphics card or on any CPU by Mesa's software rasteriser.
.
It draws clips, recordings of a day in many files, live streams and whole
archives, as pictures or as pages from which the video can be watched.")
set(CPACK_DEBIAN_PACKAGE_SECTION video)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

# Linked libraries are found by dpkg-shlibdeps; those that the program opens while it runs are listed.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
file(STRINGS ${PROJECT_SOURCE_DIR}/scripts/packages.txt opened REGEX "^run: ")
list(TRANSFORM opened REPLACE "^run: *" "")
list(JOIN opened ", " CPACK_DEBIAN_PACKAGE_DEPENDS)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/scripts/packages.txt)

# What Debian wants otherwise than an install from sources has it.
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/scripts/cmake/debian_tree.cmake)
set(CPACK_POST_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/scripts/cmake/debian_scripts.cmake)
set(CPACK_VVR_EPOCH ${VVR_EPOCH})
set(CPACK_VVR_PYTHON ${DEBIAN_PYTHON})
set(CPACK_VVR_SOURCES ${PROJECT_SOURCE_DIR})
include(CPack)
