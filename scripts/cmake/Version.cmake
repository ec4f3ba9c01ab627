# VVR_VERSION: what `vvr --version` says. VVR_VERSION_NUMBER: its numbers alone. VVR_VERSION_SERIES: the first two of
# them.
#
# In a clone with tags they come from the last tag of the form v1.2.3 or v1.2.3-rc.1:
#
#   the tag itself          1.2.3                     v1.2.3-rc.1: 1.2.3-rc.1
#   12 commits later        1.2.3+12.gabcdef0123
#   and with changed files  1.2.3+12.gabcdef0123.dirty
#
# Else, in a tarball or a shallow clone, from project(). They are read when CMake configures.
#
# As a script it prints them: cmake -DPROJECT_SOURCE_DIR=FOLDER -DPROJECT_VERSION=1.2.3 -P scripts/cmake/Version.cmake
function(vvr_version)
  set(number ${PROJECT_VERSION})
  set(version ${PROJECT_VERSION})
  # A folder within someone else's repository has none of its tags.
  execute_process(COMMAND git -C ${PROJECT_SOURCE_DIR} rev-parse --show-prefix
    OUTPUT_VARIABLE prefix OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed AND prefix STREQUAL "")
    execute_process(COMMAND git -C ${PROJECT_SOURCE_DIR} describe --tags --match "v[0-9]*" --long --dirty=.dirty --abbrev=10
      OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(described MATCHES "^v([0-9]+\\.[0-9]+\\.[0-9]+)(-[0-9A-Za-z.]+)?-([0-9]+)-(g[0-9a-f]+)(\\.dirty)?$")
      set(number ${CMAKE_MATCH_1})
      set(version ${CMAKE_MATCH_1}${CMAKE_MATCH_2})
      if(CMAKE_MATCH_3 GREATER 0 OR CMAKE_MATCH_5)
        string(APPEND version "+${CMAKE_MATCH_3}.${CMAKE_MATCH_4}${CMAKE_MATCH_5}")
      endif()
    elseif(described)
      message(WARNING "the tag in '${described}' is no version of the form v1.2.3; the version is ${version}")
    endif()
  endif()
  string(REGEX MATCH "^[0-9]+\\.[0-9]+" series ${number})
  set(VVR_VERSION ${version} PARENT_SCOPE)
  set(VVR_VERSION_SERIES ${series} PARENT_SCOPE)
  set(VVR_VERSION_NUMBER ${number} PARENT_SCOPE)
endfunction()

vvr_version()
if(CMAKE_SCRIPT_MODE_FILE)
  message("${VVR_VERSION} ${VVR_VERSION_NUMBER}")
endif()
