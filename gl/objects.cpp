#include "gl/objects.h"

#include "core/image/picture.h"
#include "gl/context.h"

namespace vvr::gl {

namespace {

/// OpenGL's internal format and pixel format of a plane.
struct Storage {
    GLint internal;
    GLenum format;
};

constexpr Storage storage_of(const Plane<std::uint8_t>&) {
    return {GL_R8, GL_RED};
}
constexpr Storage storage_of(const Plane<Bgr>&) {
    return {GL_RGB8, GL_BGR};
}

template <class T>
void upload_level(const GladGLContext& gl, GLenum target, GLint level, const Plane<T>& plane) {
    const auto [internal, format] = storage_of(plane);
    if (target == GL_TEXTURE_1D) {
        gl.TexImage1D(target, level, internal, plane.width(), 0, format, GL_UNSIGNED_BYTE, plane.pixels().data());
    } else {
        gl.TexImage2D(target, level, internal, plane.width(), plane.height(), 0, format, GL_UNSIGNED_BYTE,
                      plane.pixels().data());
    }
}

template <class T>
GlTexture make_smooth(const GladGLContext& gl, GLenum target, GLint wrap, const Plane<T>& plane) {
    GlTexture texture(gl);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(target, texture.id());
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(target, GL_TEXTURE_WRAP_S, wrap);
    gl.TexParameteri(target, GL_TEXTURE_WRAP_T, wrap);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    upload_level(gl, target, 0, plane);
    GLint number = 0;
    for (const Plane<T>& level : image::mip_levels(plane)) upload_level(gl, target, ++number, level);
    check_gl(gl, "uploading a mipmapped texture");
    return texture;
}

}  // namespace

GlTexture mipmapped_texture(const GladGLContext& gl, const Plane<std::uint8_t>& picture) {
    return make_smooth(gl, GL_TEXTURE_2D, GL_CLAMP_TO_EDGE, picture);
}

GlTexture mipmapped_texture(const GladGLContext& gl, const Plane<Bgr>& picture) {
    return make_smooth(gl, GL_TEXTURE_2D, GL_CLAMP_TO_EDGE, picture);
}

GlTexture mipmapped_repeating_texture(const GladGLContext& gl, const Plane<std::uint8_t>& row) {
    return make_smooth(gl, GL_TEXTURE_1D, GL_REPEAT, row);
}

}  // namespace vvr::gl
