# A room of the house: a folder, and a library of its own. It sees the rooms that it links, and no others: an include of
# another room's header does not link.
#
#   vvr_room(NAME FILES... ROOMS room... LIBRARIES lib...)
#
# makes the library vvr_NAME. LIBRARIES are those that only its own files use.

# Has a library use the precompiled headers of vvr_base, if there are any.
function(vvr_precompile library)
  if(VVR_PRECOMPILE)
    target_precompile_headers(${library} REUSE_FROM vvr_base)
  endif()
endfunction()

function(vvr_room name)
  cmake_parse_arguments(arg "" "" "ROOMS;LIBRARIES" ${ARGN})
  add_library(vvr_${name} STATIC ${arg_UNPARSED_ARGUMENTS})
  list(TRANSFORM arg_ROOMS PREPEND vvr_)
  target_link_libraries(vvr_${name} PUBLIC vvr_flags ${arg_ROOMS} PRIVATE ${arg_LIBRARIES})
  vvr_precompile(vvr_${name})
endfunction()
