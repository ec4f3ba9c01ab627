#pragma once

#include <string_view>

#include <glad/gl.h>

namespace vvr::gl {

/// Throws if OpenGL has recorded an error since the last check.
/// \param doing the operation, for the message
/// \throws Error limit if OpenGL ran out of memory, backend for any other error
void check_gl(const GladGLContext& gl, std::string_view doing);

/// Drivers report arbitrary errors when memory is short. Throws if the process can't allocate what OpenGL needs at
/// startup, otherwise does nothing.
/// \param failure the driver's message
/// \throws Error limit
void throw_if_out_of_memory(std::string_view failure);

}  // namespace vvr::gl
