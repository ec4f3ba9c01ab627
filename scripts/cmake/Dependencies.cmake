# Every library that vvr needs. scripts/packages.txt installs them from Debian.
find_package(PkgConfig REQUIRED)
pkg_check_modules(libav REQUIRED IMPORTED_TARGET libavformat libavcodec libavutil libswscale)
# Debian's CMake files of OpenImageIO ask for its Qt tools as well; pkg-config doesn't.
pkg_check_modules(oiio REQUIRED IMPORTED_TARGET OpenImageIO)

pkg_check_modules(png REQUIRED IMPORTED_TARGET libpng)
pkg_check_modules(turbojpeg REQUIRED IMPORTED_TARGET libturbojpeg)
pkg_check_modules(webp REQUIRED IMPORTED_TARGET libwebp)

# The shapes, ligatures and order of the letters of any script.
pkg_check_modules(raqm REQUIRED IMPORTED_TARGET raqm)

# Regular expressions in time that the text's length bounds, for names that anybody may have written.
pkg_check_modules(re2 REQUIRED IMPORTED_TARGET re2)

# Filters of system calls.
pkg_check_modules(seccomp REQUIRED IMPORTED_TARGET libseccomp)

# OpenCV's CMake files are in the package of all its modules; we want four of them.
find_path(OPENCV_INCLUDE opencv2/core.hpp PATH_SUFFIXES opencv4 REQUIRED)
foreach(module core dnn imgproc video)
  find_library(OPENCV_${module} opencv_${module} REQUIRED)
  add_library(opencv::${module} UNKNOWN IMPORTED)
  set_target_properties(opencv::${module} PROPERTIES
    IMPORTED_LOCATION ${OPENCV_${module}}
    INTERFACE_INCLUDE_DIRECTORIES ${OPENCV_INCLUDE}
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES ${OPENCV_INCLUDE})
endforeach()

# The messages of ONNX files. Debian's CMake files of onnx ask for its optimizer as well.
find_path(ONNX_INCLUDE onnx/onnx_pb.h REQUIRED)
find_library(ONNX_PROTO onnx_proto REQUIRED)
find_library(PROTOBUF protobuf REQUIRED)
add_library(onnx::proto UNKNOWN IMPORTED)
set_target_properties(onnx::proto PROPERTIES
  IMPORTED_LOCATION ${ONNX_PROTO}
  INTERFACE_LINK_LIBRARIES ${PROTOBUF}
  INTERFACE_COMPILE_DEFINITIONS "ONNX_ML=1;ONNX_NAMESPACE=onnx"
  INTERFACE_SYSTEM_INCLUDE_DIRECTORIES ${ONNX_INCLUDE})

find_package(ZLIB REQUIRED)
find_package(Fontconfig REQUIRED)
find_package(Freetype REQUIRED)
find_package(TBB REQUIRED)
find_package(glm REQUIRED)
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Threads REQUIRED)

# Only the headers: libEGL and libOSMesa are opened at run time, so that one binary serves every machine.
find_path(EGL_INCLUDE EGL/egl.h REQUIRED)

# pyenv and the like put another python3 first in PATH, one without Debian's modules.
find_program(DEBIAN_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)

if(VVR_TESTS)
  find_package(GTest REQUIRED)
endif()
