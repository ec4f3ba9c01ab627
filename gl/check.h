#pragma once

#include <string_view>

#include <glad/gl.h>

namespace vvr::gl {

/// Asks OpenGL whether anything has gone wrong since the last check.
/// \param doing what was tried, for the message
/// \throws Error limit when OpenGL ran out of memory, backend for any other error
void check_gl(const GladGLContext& gl, std::string_view doing);

}  // namespace vvr::gl
