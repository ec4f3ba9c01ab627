#include "gl/framebuffer.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.h"
#include "gl/check.h"

namespace vvr {

void check_samples(const GladGLContext& gl, int samples) {
    GLint most = 0;
    gl.GetIntegerv(GL_MAX_SAMPLES, &most);
    if (samples <= most) return;
    throw Error(ErrorKind::limit, fmt::format("--samples {}: this OpenGL has at most {} a pixel; choose {} or fewer",
                                              samples, most, most));
}

Framebuffer::Framebuffer(const GladGLContext& gl, Size size, int samples) : gl_(&gl), size_(size), samples_(samples) {
    GLint largest = 0;
    gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    if (size.width > largest || size.height > largest) {
        throw Error(ErrorKind::limit, fmt::format("a picture of {}x{} was asked for, this OpenGL draws at most {}x{}",
                                                  size.width, size.height, largest, largest));
    }
    check_samples(gl, samples);
    drawn_ = make_target(samples);
    if (samples > 1) resolved_ = make_target(1);
}

Framebuffer::Target Framebuffer::make_target(int samples) const {
    const GladGLContext& gl = *gl_;
    Target target{GlFramebuffer(gl), GlRenderbuffer(gl), GlRenderbuffer(gl)};
    // Multisampled storage with one sample is not the same as storage without: only the latter can be read.
    const GLsizei stored = samples > 1 ? samples : 0;
    gl.BindRenderbuffer(GL_RENDERBUFFER, target.colour.id());
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, stored, GL_RGBA32F, size_.width, size_.height);
    gl.BindRenderbuffer(GL_RENDERBUFFER, target.depth.id());
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, stored, GL_DEPTH_COMPONENT24, size_.width, size_.height);
    gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target.colour.id());
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth.id());
    check_gl(gl, fmt::format("making a framebuffer of {}x{} with {} samples", size_.width, size_.height, samples));
    const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        throw Error(ErrorKind::backend, fmt::format("a framebuffer of {}x{} with {} samples is not complete ({:#x})",
                                                    size_.width, size_.height, samples, status));
    }
    return target;
}

void Framebuffer::bind(Size size) const {
    gl_->BindFramebuffer(GL_FRAMEBUFFER, drawn_.framebuffer.id());
    gl_->Viewport(0, 0, size.width, size.height);
}

void Framebuffer::read(const Tile& tile, Plane<glm::vec4>& picture) const {
    const GladGLContext& gl = *gl_;
    const Size size = tile.size;
    if (samples_ > 1) {
        gl.BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.framebuffer.id());
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.framebuffer.id());
        gl.BlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height, GL_COLOR_BUFFER_BIT,
                           GL_NEAREST);
        gl.BindFramebuffer(GL_FRAMEBUFFER, resolved_.framebuffer.id());
    } else {
        gl.BindFramebuffer(GL_FRAMEBUFFER, drawn_.framebuffer.id());
    }
    read_pixels(gl, tile, picture);
}

void read_pixels(const GladGLContext& gl, const Tile& tile, Plane<glm::vec4>& picture) {
    gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl.PixelStorei(GL_PACK_ROW_LENGTH, picture.width());
    gl.ReadPixels(0, 0, tile.size.width, tile.size.height, GL_RGBA, GL_FLOAT, &picture.at(tile.column, tile.row));
    gl.PixelStorei(GL_PACK_ROW_LENGTH, 0);
    check_gl(gl, "reading the picture back");
    const auto row = [&](int j) {
        return picture.row(tile.row + j)
            .subspan(static_cast<std::size_t>(tile.column), static_cast<std::size_t>(tile.size.width));
    };
    for (int j = 0; j < tile.size.height / 2; ++j) std::ranges::swap_ranges(row(j), row(tile.size.height - 1 - j));
}

}  // namespace vvr
