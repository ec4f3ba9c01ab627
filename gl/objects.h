#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <glad/gl.h>

#include "core/base/plane.h"

namespace vvr::gl {

/// Move-only owner of an OpenGL object. Its context must be current on destruction.
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

/// Objects created by glGen… and deleted by glDelete… .
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

/// Whether an attribute advances per vertex or per instance.
enum class Per { vertex, instance };

/// Adds an attribute of `size` floats, read from the bound buffer, to the bound vertex array.
/// \tparam Vertex element type of the buffer
/// \param offset bytes from the start of a Vertex
template <class Vertex>
void set_attribute(const GladGLContext& gl, GLuint attribute, GLint size, std::size_t offset, Per per) {
    gl.EnableVertexAttribArray(attribute);
    gl.VertexAttribPointer(attribute, size, GL_FLOAT, GL_FALSE, sizeof(Vertex), std::bit_cast<const void*>(offset));
    if (per == Per::instance) gl.VertexAttribDivisor(attribute, 1);
}

/// A mipmapped 2D texture of one channel or of BGR pixels. The CPU computes the mipmap levels: for glGenerateMipmap,
/// Mesa's software rasteriser compiles its own shaders, which costs 0.25 s per run.
/// \throws Error limit if memory runs out, backend for any other error
GlTexture mipmapped_texture(const GladGLContext& gl, const Plane<std::uint8_t>& picture);
GlTexture mipmapped_texture(const GladGLContext& gl, const Plane<Bgr>& picture);

/// A mipmapped, repeating 1D texture of one row of bytes.
GlTexture mipmapped_repeating_texture(const GladGLContext& gl, const Plane<std::uint8_t>& row);

}  // namespace vvr::gl
