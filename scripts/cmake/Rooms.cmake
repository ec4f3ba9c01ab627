# A room of the house: a folder, and a library of its own. It sees the rooms that it links, and no others: an include of
# another room's header does not link.
#
#   vvr_room(NAME FILES... ROOMS room... LIBRARIES lib...)
#
# makes the library vvr_NAME. LIBRARIES are those that only its own files use.
function(vvr_room name)
  cmake_parse_arguments(arg "" "" "ROOMS;LIBRARIES" ${ARGN})
  add_library(vvr_${name} STATIC ${arg_UNPARSED_ARGUMENTS})
  list(TRANSFORM arg_ROOMS PREPEND vvr_)
  target_link_libraries(vvr_${name} PUBLIC vvr_flags ${arg_ROOMS} PRIVATE ${arg_LIBRARIES})
endfunction()
