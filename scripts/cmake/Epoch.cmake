# VVR_EPOCH: the date of what is built, in seconds since 1970, so that two builds of the same sources give the same bytes:
# SOURCE_DATE_EPOCH, else that of the last commit, else that of the last change of CHANGELOG.md.
set(VVR_EPOCH $ENV{SOURCE_DATE_EPOCH})
if(NOT VVR_EPOCH AND VVR_IS_CLONE)
  execute_process(COMMAND git -C ${PROJECT_SOURCE_DIR} log -1 --format=%ct
    OUTPUT_VARIABLE VVR_EPOCH OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(NOT VVR_EPOCH)
  file(TIMESTAMP ${PROJECT_SOURCE_DIR}/CHANGELOG.md VVR_EPOCH %s UTC)
endif()
