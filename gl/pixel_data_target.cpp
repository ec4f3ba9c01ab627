#include "gl/pixel_data_target.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "gl/check.h"
#include "gl/framebuffer.h"
#include "gl/memory.h"

namespace vvr::gl {

namespace {

constexpr int behind_unit = 2;
constexpr int object_behind_unit = 4;

constexpr std::array<GLenum, 2> attachments{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};

/// Makes a texture that is drawn into and read texel by texel.
void allocate(const GladGLContext& gl, const GlTexture& texture, GLint internal, GLenum format, Size size) {
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexImage2D(GL_TEXTURE_2D, 0, internal, size.width, size.height, 0, format, GL_FLOAT, nullptr);
}

}  // namespace

PixelDataTarget::PixelDataTarget(const GladGLContext& gl, Size size)
    : gl_(&gl),
      data_{Data{GlFramebuffer(gl), GlTexture(gl), GlTexture(gl)},
            Data{GlFramebuffer(gl), GlTexture(gl), GlTexture(gl)}},
      depth_(gl) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, depth_.id());
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size.width, size.height);
    for (const Data& data : data_) {
        allocate(gl, data.texture, GL_RGBA32F, GL_RGBA, size);
        allocate(gl, data.objects, GL_R32F, GL_RED, size);
        gl.BindFramebuffer(GL_FRAMEBUFFER, data.framebuffer.id());
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, data.texture.id(), 0);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, data.objects.id(), 0);
        gl.DrawBuffers(static_cast<GLsizei>(attachments.size()), attachments.data());
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
        const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
        if (status != GL_FRAMEBUFFER_COMPLETE) {
            const std::string failure = fmt::format("a framebuffer for the pixel data of {}x{} is not complete ({:#x})",
                                                    size.width, size.height, status);
            throw_if_out_of_memory(failure);
            throw Error(ErrorKind::backend, failure);
        }
    }
    check_gl(gl, "making a framebuffer for pixel data");
}

void PixelDataTarget::begin(Size size) const {
    gl_->BindFramebuffer(GL_FRAMEBUFFER, data_[0].framebuffer.id());
    gl_->Viewport(0, 0, size.width, size.height);
    gl_->ClearColor(0, 0, 0, 0);
    gl_->DepthMask(GL_TRUE);
    gl_->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void PixelDataTarget::begin_before_geometry() const {
    gl_->Clear(GL_COLOR_BUFFER_BIT);
}

void PixelDataTarget::draw_over(const Program& program, const std::function<void()>& draw) const {
    gl_->Enable(GL_DEPTH_TEST);
    gl_->DepthMask(GL_FALSE);
    gl_->Disable(GL_BLEND);
    program.set("behind", behind_unit);
    program.set("object_behind", object_behind_unit);
    if (gl_->ARB_texture_barrier != 0) {
        // What is drawn may be read again by the next step: no copy, and no change of framebuffers.
        read_from(data_[0]);
        program.set("take_over", 0);
        gl_->TextureBarrier();
        draw();
        return;
    }
    for (const std::size_t from : {0U, 1U}) {
        gl_->BindFramebuffer(GL_FRAMEBUFFER, data_[1 - from].framebuffer.id());
        read_from(data_[from]);
        program.set("take_over", from == 1 ? 1 : 0);
        draw();
    }
}

void PixelDataTarget::read_from(const Data& data) const {
    gl_->ActiveTexture(GL_TEXTURE0 + behind_unit);
    gl_->BindTexture(GL_TEXTURE_2D, data.texture.id());
    gl_->ActiveTexture(GL_TEXTURE0 + object_behind_unit);
    gl_->BindTexture(GL_TEXTURE_2D, data.objects.id());
    gl_->ActiveTexture(GL_TEXTURE0);
}

Plane<glm::vec4> PixelDataTarget::read(Size size) const {
    return read_attachment(GL_COLOR_ATTACHMENT0, size);
}

Plane<glm::vec4> PixelDataTarget::read_objects(Size size) const {
    return read_attachment(GL_COLOR_ATTACHMENT1, size);
}

Plane<glm::vec4> PixelDataTarget::read_attachment(GLenum attachment, Size size) const {
    gl_->BindFramebuffer(GL_FRAMEBUFFER, data_[0].framebuffer.id());
    gl_->ReadBuffer(attachment);
    auto data = Plane<glm::vec4>::for_overwrite(size);
    read_pixels(*gl_, {0, 0, size.width, size.height}, data);
    return data;
}

}  // namespace vvr::gl
