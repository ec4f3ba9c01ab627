#include "gl/framebuffer.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/error.h"
#include "gl/context.h"

namespace vvr::gl {

void check_samples(const GladGLContext& gl, int samples) {
    GLint max_drawn = 0;
    GLint max_sampled = 0;
    gl.GetIntegerv(GL_MAX_SAMPLES, &max_drawn);
    gl.GetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &max_sampled);
    const GLint most = std::min(max_drawn, max_sampled);
    if (samples <= most) return;
    throw Error(
        ErrorCode::limit,
        fmt::format("samples {}: this OpenGL supports at most {} per pixel; choose {} or fewer", samples, most, most),
        {"samples"});
}

std::vector<PixelBox> cut_tiles(Size picture, std::int64_t pixels) {
    const int width = static_cast<int>(std::clamp<std::int64_t>(pixels, 1, picture.width));
    const int height = static_cast<int>(std::clamp<std::int64_t>(pixels / width, 1, picture.height));
    std::vector<PixelBox> tiles;
    for (int top = 0; top < picture.height; top += height) {
        for (int left = 0; left < picture.width; left += width) {
            tiles.push_back({left, top, std::min(left + width, picture.width), std::min(top + height, picture.height)});
        }
    }
    return tiles;
}

Framebuffer::Framebuffer(const GladGLContext& gl, Size size, int samples) : gl_(&gl), size_(size), samples_(samples) {
    GLint largest = 0;
    gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    if (size.width > largest || size.height > largest) {
        throw Error(ErrorCode::picture_too_large,
                    fmt::format("a picture of {}x{} is larger than this OpenGL draws ({}x{}); choose a smaller picture",
                                size.width, size.height, largest, largest),
                    {"size"});
    }
    check_samples(gl, samples);
    drawn_ = make_drawn();
    if (samples > 1) resolved_ = make_resolved();
}

Framebuffer::Drawn Framebuffer::make_drawn() const {
    const GladGLContext& gl = *gl_;
    Drawn drawn{GlFramebuffer(gl), GlTexture(gl), GlRenderbuffer(gl), GlRenderbuffer(gl)};
    gl.BindFramebuffer(GL_FRAMEBUFFER, drawn.framebuffer.id());
    gl.BindRenderbuffer(GL_RENDERBUFFER, drawn.depth.id());
    if (samples_ > 1) {
        gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, drawn.samples.id());
        gl.TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples_, GL_RGBA32F, size_.width, size_.height, GL_TRUE);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, drawn.samples.id(), 0);
        gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_DEPTH_COMPONENT24, size_.width, size_.height);
    } else {
        // Storage with one sample still counts as multisampled and can't be read back, so use plain storage.
        gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size_.width, size_.height);
        gl.BindRenderbuffer(GL_RENDERBUFFER, drawn.colour.id());
        gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, size_.width, size_.height);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, drawn.colour.id());
    }
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, drawn.depth.id());
    check_complete(samples_);
    return drawn;
}

Framebuffer::Resolved Framebuffer::make_resolved() const {
    const GladGLContext& gl = *gl_;
    Resolved resolved{GlFramebuffer(gl), GlRenderbuffer(gl), GlVertexArray(gl), Program(gl, resolve_program())};
    gl.BindFramebuffer(GL_FRAMEBUFFER, resolved.framebuffer.id());
    gl.BindRenderbuffer(GL_RENDERBUFFER, resolved.colour.id());
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, size_.width, size_.height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, resolved.colour.id());
    check_complete(1);
    return resolved;
}

void Framebuffer::check_complete(int samples) const {
    check_gl(*gl_, fmt::format("making a framebuffer of {}x{} with {} samples", size_.width, size_.height, samples));
    const GLenum status = gl_->CheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE) return;
    const std::string failure = fmt::format("a framebuffer of {}x{} with {} samples is incomplete ({:#x})", size_.width,
                                            size_.height, samples, status);
    throw_if_out_of_memory(failure);
    throw Error(ErrorCode::backend, failure);
}

void Framebuffer::bind(Size size) const {
    gl_->BindFramebuffer(GL_FRAMEBUFFER, drawn_.framebuffer.id());
    gl_->Viewport(0, 0, size.width, size.height);
}

void Framebuffer::read(const PixelBox& tile, Plane<glm::vec4>& picture) const {
    const GladGLContext& gl = *gl_;
    if (resolved_) {
        resolve(tile.size());
    } else {
        gl.BindFramebuffer(GL_FRAMEBUFFER, drawn_.framebuffer.id());
    }
    read_pixels(gl, tile, picture);
}

/// Uses our own shader: for glBlitFramebuffer, Mesa's software rasteriser compiles one in each run.
void Framebuffer::resolve(Size size) const {
    const GladGLContext& gl = *gl_;
    gl.BindFramebuffer(GL_FRAMEBUFFER, resolved_->framebuffer.id());
    gl.Viewport(0, 0, size.width, size.height);
    gl.Disable(GL_DEPTH_TEST);
    gl.Disable(GL_BLEND);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, drawn_.samples.id());
    resolved_->program.use();
    resolved_->program.set("drawn", 0);
    resolved_->program.set("samples", samples_);
    gl.BindVertexArray(resolved_->vertex_array.id());
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.BindVertexArray(0);
}

void read_pixels(const GladGLContext& gl, const PixelBox& tile, Plane<glm::vec4>& picture) {
    gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl.PixelStorei(GL_PACK_ROW_LENGTH, picture.width());
    gl.ReadPixels(0, 0, tile.width(), tile.height(), GL_RGBA, GL_FLOAT, &picture.at(tile.left, tile.top));
    gl.PixelStorei(GL_PACK_ROW_LENGTH, 0);
    check_gl(gl, "reading the picture back");
    const auto row = [&](int j) {
        return picture.row(tile.top + j)
            .subspan(static_cast<std::size_t>(tile.left), static_cast<std::size_t>(tile.width()));
    };
    for (int j = 0; j < tile.height() / 2; ++j) std::ranges::swap_ranges(row(j), row(tile.height() - 1 - j));
}

namespace {

constexpr int behind_unit = 2;
constexpr int object_behind_unit = 4;

constexpr std::array<GLenum, 2> attachments{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};

/// Allocates a texture for rendering and for texelFetch.
void allocate(const GladGLContext& gl, const GlTexture& texture, GLint internal, GLenum format, Size size) {
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexImage2D(GL_TEXTURE_2D, 0, internal, size.width, size.height, 0, format, GL_FLOAT, nullptr);
}

}  // namespace

PixelDataTarget::PixelDataTarget(const GladGLContext& gl, Size size) : gl_(&gl), depth_(gl) {
    const std::size_t buffers = gl.EXT_shader_framebuffer_fetch != 0 ? 1 : 2;
    while (data_.size() < buffers) data_.push_back({GlFramebuffer(gl), GlTexture(gl), GlTexture(gl)});
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
            const std::string failure = fmt::format("a framebuffer for the pixel data of {}x{} is incomplete ({:#x})",
                                                    size.width, size.height, status);
            throw_if_out_of_memory(failure);
            throw Error(ErrorCode::backend, failure);
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
    if (fetches()) {
        draw();
        return;
    }
    program.set("behind", behind_unit);
    program.set("object_behind", object_behind_unit);
    for (const std::size_t from : {0U, 1U}) {
        gl_->BindFramebuffer(GL_FRAMEBUFFER, data_[1 - from].framebuffer.id());
        read_from(data_[from]);
        program.set("copy_only", from == 1 ? 1 : 0);
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
