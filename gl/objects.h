#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <glad/gl.h>

#include "core/base/plane.h"

namespace vvr::gl {

/// Move-only owner of an OpenGL object. Its context must be current when it goes.
template <class Traits>
class GlObject {
  public:
    GlObject() = default;
    explicit GlObject(const GladGLContext& gl) : gl_(&gl), id_(Traits::create(gl)) {}
    ~GlObject() { reset(); }
    GlObject(GlObject&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        if (this != &other) {
            reset();
            gl_ = other.gl_;
            id_ = std::exchange(other.id_, 0);
        }
        return *this;
    }
    GlObject(const GlObject&) = delete;
    GlObject& operator=(const GlObject&) = delete;

    GLuint id() const { return id_; }
    explicit operator bool() const { return id_ != 0; }

  private:
    void reset() {
        if (id_ != 0) Traits::destroy(*gl_, id_);
        id_ = 0;
    }

    const GladGLContext* gl_ = nullptr;
    GLuint id_ = 0;
};

/// The objects that come and go by glGen… and glDelete… .
template <auto Gen, auto Delete>
struct GenTraits {
    static GLuint create(const GladGLContext& gl) {
        GLuint id = 0;
        (gl.*Gen)(1, &id);
        return id;
    }
    static void destroy(const GladGLContext& gl, GLuint id) { (gl.*Delete)(1, &id); }
};

struct ProgramTraits {
    static GLuint create(const GladGLContext& gl) { return gl.CreateProgram(); }
    static void destroy(const GladGLContext& gl, GLuint id) { gl.DeleteProgram(id); }
};

template <GLenum Type>
struct ShaderTraits {
    static GLuint create(const GladGLContext& gl) { return gl.CreateShader(Type); }
    static void destroy(const GladGLContext& gl, GLuint id) { gl.DeleteShader(id); }
};

using GlBuffer = GlObject<GenTraits<&GladGLContext::GenBuffers, &GladGLContext::DeleteBuffers>>;
using GlTexture = GlObject<GenTraits<&GladGLContext::GenTextures, &GladGLContext::DeleteTextures>>;
using GlVertexArray = GlObject<GenTraits<&GladGLContext::GenVertexArrays, &GladGLContext::DeleteVertexArrays>>;
using GlFramebuffer = GlObject<GenTraits<&GladGLContext::GenFramebuffers, &GladGLContext::DeleteFramebuffers>>;
using GlRenderbuffer = GlObject<GenTraits<&GladGLContext::GenRenderbuffers, &GladGLContext::DeleteRenderbuffers>>;
using GlProgram = GlObject<ProgramTraits>;
using GlVertexShader = GlObject<ShaderTraits<GL_VERTEX_SHADER>>;
using GlFragmentShader = GlObject<ShaderTraits<GL_FRAGMENT_SHADER>>;

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

/// A texture with mip levels, of bytes as one channel or of a picture's colours. The levels are computed on the CPU:
/// for glGenerateMipmap Mesa's software rasteriser compiles shaders of its own, which takes a quarter of a second in
/// each run.
///
/// \throws Error limit when there is no memory for it, backend for anything else, as check_gl does
GlTexture mipmapped_texture(const GladGLContext& gl, const Plane<std::uint8_t>& picture);
GlTexture mipmapped_texture(const GladGLContext& gl, const Plane<Bgr>& picture);

/// A one-dimensional one that repeats, of a row of bytes.
GlTexture mipmapped_repeating_texture(const GladGLContext& gl, const Plane<std::uint8_t>& row);

}  // namespace vvr::gl
