# The flags of our own code; what others wrote is included as system headers and keeps its own.
add_library(vvr_flags INTERFACE)
target_include_directories(vvr_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(vvr_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)

if(VVR_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  # Under the sanitizers GCC 12 takes members of its own <regex> for uninitialised.
  target_compile_options(vvr_flags INTERFACE -Wno-maybe-uninitialized)
  add_link_options(-fsanitize=address,undefined)
endif()

if(VVR_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()

# See tests/support/keep_libraries.cpp.
function(vvr_keep_libraries program)
  if(VVR_SANITIZE)
    target_sources(${program} PRIVATE ${PROJECT_SOURCE_DIR}/tests/support/keep_libraries.cpp)
  endif()
endfunction()
