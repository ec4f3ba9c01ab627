# Turns text files into string constants, so that the program needs no file beside it.
#
#   vvr_embed(TARGET NAMESPACE HEADER FILE...)
#
# makes HEADER with one `inline constexpr std::string_view` for each FILE: volume.frag becomes volume_frag. Its array
# `files` has the name and the text of each.
function(vvr_embed target namespace header)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/embedded/${header})
  set(files)
  foreach(file IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH file)
    list(APPEND files ${file})
  endforeach()
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DNAMESPACE=${namespace} "-DFILES=${files}" -P ${PROJECT_SOURCE_DIR}/scripts/cmake/embed.cmake
    DEPENDS ${files} ${PROJECT_SOURCE_DIR}/scripts/cmake/embed.cmake
    COMMENT "Embedding ${header}" VERBATIM)
  add_custom_target(${target}_files DEPENDS ${output})
  add_library(${target} INTERFACE)
  target_include_directories(${target} INTERFACE ${CMAKE_CURRENT_BINARY_DIR}/embedded)
  add_dependencies(${target} ${target}_files)
endfunction()
