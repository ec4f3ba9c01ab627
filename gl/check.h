#pragma once

#include <string_view>

#include <glad/gl.h>

namespace vvr::gl {

/// Asks OpenGL whether anything has gone wrong since the last check.
/// \param doing what was tried, for the message
/// \throws Error limit when OpenGL ran out of memory, backend for any other error
void check_gl(const GladGLContext& gl, std::string_view doing);

/// Does nothing but where the process may not have what OpenGL takes to begin with. Then a driver says anything of what
/// fails, and memory is to blame.
/// \param failure what it says
/// \throws Error limit
void throw_if_out_of_memory(std::string_view failure);

}  // namespace vvr::gl
