#pragma once

#include <bit>
#include <cstddef>

#include <glad/gl.h>

namespace vvr::gl {

/// What an attribute of the vertex array in use advances with.
enum class Per { vertex, instance };

/// Gives the vertex array in use an attribute of `size` floats.
/// \tparam Vertex what the buffer in use holds
/// \param offset in bytes, in the Vertex
template <class Vertex>
void set_attribute(const GladGLContext& gl, GLuint attribute, GLint size, std::size_t offset, Per per) {
    gl.EnableVertexAttribArray(attribute);
    gl.VertexAttribPointer(attribute, size, GL_FLOAT, GL_FALSE, sizeof(Vertex), std::bit_cast<const void*>(offset));
    if (per == Per::instance) gl.VertexAttribDivisor(attribute, 1);
}

}  // namespace vvr::gl
