# A module: a folder, and a library of its own. It sees the modules that it links, and no others: an include of
# another module's header does not link.
#
#   vvr_module(NAME [COLD] FILES... MODULES module... LIBRARIES lib...)
#
# makes the library vvr_NAME. LIBRARIES are those that only its own files use. A run spends little time in the code of a COLD
# module, so that is compiled with -O1, in three quarters of the time.

function(vvr_module name)
  cmake_parse_arguments(arg "COLD" "" "MODULES;LIBRARIES" ${ARGN})
  add_library(vvr_${name} STATIC ${arg_UNPARSED_ARGUMENTS})
  list(TRANSFORM arg_MODULES PREPEND vvr_)
  target_link_libraries(vvr_${name} PUBLIC vvr_flags ${arg_MODULES} PRIVATE ${arg_LIBRARIES})
  if(arg_COLD)
    target_compile_options(vvr_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()
