# The flags of our own code; what others wrote is included as system headers and keeps its own.
add_library(vvr_flags INTERFACE)
target_include_directories(vvr_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(vvr_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)
if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
  # The scripts of the web pages are strings of 100 KB, which every compiler takes.
  target_compile_options(vvr_flags INTERFACE -Wno-overlength-strings)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
  # From GCC 13 on, these take references to members, moved optionals, and code of fmt that never runs for faults.
  target_compile_options(vvr_flags INTERFACE -Wno-dangling-reference -Wno-maybe-uninitialized -Wno-array-bounds
    -Wno-stringop-overflow)
endif()
if(VVR_UNITY) # names of one file are seen by the next ones
  target_compile_options(vvr_flags INTERFACE -Wno-shadow -Wno-subobject-linkage)
endif()

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

# Hardening: what a hostile clip could overwrite, jump to or read is checked, moved or read-only. Each flag is used where
# the compiler knows it for this processor; -fcf-protection is for x86, -mbranch-protection for ARM.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
include(CheckPIESupported)
check_pie_supported()
include(CheckCXXCompilerFlag)
if(NOT VVR_SANITIZE)
  set(CMAKE_REQUIRED_FLAGS -Werror) # clang only warns of a flag of another processor
  foreach(flag -fstack-protector-strong -fstack-clash-protection -fcf-protection=full -mbranch-protection=standard)
    string(MAKE_C_IDENTIFIER "VVR_KNOWS${flag}" knows)
    check_cxx_compiler_flag(${flag} ${knows})
    if(${knows})
      add_compile_options(${flag})
    endif()
  endforeach()
  unset(CMAKE_REQUIRED_FLAGS)
  # It needs the optimiser. -U first, as the environment's own flags may have another level.
  add_compile_options($<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE> $<$<NOT:$<CONFIG:Debug>>:-D_FORTIFY_SOURCE=3>)
endif()
add_link_options(-Wl,-z,relro -Wl,-z,now -Wl,-z,noexecstack)

# The folder of a build is nowhere in what it makes, so that two builds give the same bytes. What is installed is built with
# the RPATH that it has there: CMake fills up another one with a colon, which stands for the folder one happens to be in.
set(VVR_SAME_RPATH BUILD_WITH_INSTALL_RPATH ON)
add_compile_options(-ffile-prefix-map=${PROJECT_BINARY_DIR}=build -ffile-prefix-map=${PROJECT_SOURCE_DIR}=.)
