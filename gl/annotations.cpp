#include "gl/annotations.h"

#include <array>
#include <cstddef>

#include "gl/context.h"
#include "gl/objects.h"

namespace vvr::gl {

namespace {

constexpr int tint_unit = 1;

void blend_over(const GladGLContext& gl, bool writes_depth) {
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthMask(writes_depth ? GL_TRUE : GL_FALSE);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

}  // namespace

Annotations::Annotations(const GladGLContext& gl)
    : gl_(&gl),
      line_program_(gl, line_program()),
      line_array_(gl),
      corners_(gl),
      segments_(gl),
      picture_program_(gl, frame_program(Channels::colour)),
      picture_array_(gl),
      picture_vertices_(gl) {
    gl.BindVertexArray(line_array_.id());
    constexpr std::array<glm::vec2, 4> corners = {glm::vec2{0, -1}, {1, -1}, {0, 1}, {1, 1}};
    gl.BindBuffer(GL_ARRAY_BUFFER, corners_.id());
    gl.BufferData(GL_ARRAY_BUFFER, sizeof(corners), corners.data(), GL_STATIC_DRAW);
    set_attribute<glm::vec2>(gl, 0, 2, 0, Per::vertex);
    gl.BindBuffer(GL_ARRAY_BUFFER, segments_.id());
    set_attribute<scene::LineSegment>(gl, 1, 3, offsetof(scene::LineSegment, from), Per::instance);
    set_attribute<scene::LineSegment>(gl, 2, 3, offsetof(scene::LineSegment, to), Per::instance);
    set_attribute<scene::LineSegment>(gl, 3, 4, offsetof(scene::LineSegment, colour), Per::instance);

    gl.BindVertexArray(picture_array_.id());
    gl.BindBuffer(GL_ARRAY_BUFFER, picture_vertices_.id());
    set_attribute<PictureVertex>(gl, 0, 3, 0, Per::vertex);
    set_attribute<PictureVertex>(gl, 1, 2, offsetof(PictureVertex, at), Per::vertex);
    gl.BindVertexArray(0);
    check_gl(gl, "setting up the annotations");
}

void Annotations::upload(const scene::FloorShadow& floor, std::span<const scene::StandingFrame> frames) {
    floor_texture_ = floor.darkness.empty() ? GlTexture() : mipmapped_texture(*gl_, floor.darkness);
    tint_texture_ = floor.tint.empty() ? GlTexture() : mipmapped_texture(*gl_, floor.tint);
    frame_textures_.clear();
    for (const scene::StandingFrame& frame : frames) frame_textures_.push_back(mipmapped_texture(*gl_, frame.picture));
}

void Annotations::draw_lines(std::span<const scene::LineSegment> lines, const space::Camera& camera, double width,
                             Size picture) {
    if (lines.empty()) return;
    const GladGLContext& gl = *gl_;
    line_program_.use();
    line_program_.set("clip_from_p", glm::mat4(camera.clip_from_p()));
    line_program_.set("half_width", glm::vec2(width / picture.width, width / picture.height));
    blend_over(gl, true);
    gl.BindVertexArray(line_array_.id());
    gl.BindBuffer(GL_ARRAY_BUFFER, segments_.id());
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(lines.size_bytes()), lines.data(), GL_STREAM_DRAW);
    gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(lines.size()));
    gl.BindVertexArray(0);
    check_gl(gl, "drawing lines");
}

void Annotations::upload_frame(const scene::StandingFrame& frame, const space::Layout& layout) {
    std::array<PictureVertex, 4> vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const double x = static_cast<double>(i & 1);
        const double y = static_cast<double>(i >> 1);
        vertices[i] = {glm::vec3(layout.p_from_c({x, y, frame.t})), glm::vec2(1 - x, 1 - y)};
    }
    upload_vertices(vertices);
}

void Annotations::upload_vertices(std::span<const PictureVertex> vertices) {
    gl_->BindVertexArray(picture_array_.id());
    gl_->BindBuffer(GL_ARRAY_BUFFER, picture_vertices_.id());
    gl_->BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size_bytes()), vertices.data(), GL_STREAM_DRAW);
}

void Annotations::draw_frame_pixel_data(const scene::StandingFrame& frame, const space::Layout& layout,
                                        const space::Camera& camera, const PixelDataTarget& target) {
    if (!pixel_data_program_) pixel_data_program_ = Program(*gl_, frame_program(Channels::pixel_data));
    pixel_data_program_->use();
    pixel_data_program_->set("clip_from_p", glm::mat4(camera.clip_from_p()));
    pixel_data_program_->set("opacity", frame.opacity);
    pixel_data_program_->set("frame", static_cast<float>(frame.frame));
    upload_frame(frame, layout);
    target.draw_over(*pixel_data_program_, [&] { gl_->DrawArrays(GL_TRIANGLE_STRIP, 0, 4); });
    gl_->BindVertexArray(0);
    check_gl(*gl_, "drawing a standing frame's pixel data");
}

void Annotations::draw_frame(const scene::StandingFrame& frame, std::size_t number, const space::Layout& layout,
                             const space::Camera& camera) {
    const GladGLContext& gl = *gl_;
    picture_program_.use();
    picture_program_.set("clip_from_p", glm::mat4(camera.clip_from_p()));
    picture_program_.set("picture", 0);
    picture_program_.set("opacity", frame.opacity);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, frame_textures_[number].id());
    blend_over(gl, frame.opacity >= 1);
    upload_frame(frame, layout);
    gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl.BindVertexArray(0);
    check_gl(gl, "drawing a standing frame");
}

void Annotations::draw_floor(const scene::FloorShadow& floor, const space::Layout& layout,
                             const space::Camera& camera) {
    if (floor.darkness.empty()) return;
    constexpr int steps = 128;
    const GladGLContext& gl = *gl_;
    if (!floor_program_) floor_program_ = Program(gl, floor_program());
    std::vector<PictureVertex> vertices;
    for (int i = 0; i <= steps; ++i) {
        const double along = static_cast<double>(i) / steps;
        for (const double x : {0.0, 1.0}) {
            vertices.push_back({glm::vec3(layout.p_from_c({x, 0, along * floor.t_end})), glm::vec2(1 - x, along)});
        }
    }
    floor_program_->use();
    floor_program_->set("clip_from_p", glm::mat4(camera.clip_from_p()));
    floor_program_->set("darkness", 0);
    floor_program_->set("shadow", floor.colour);
    floor_program_->set("tint", tint_unit);
    floor_program_->set("tinted", floor.tint.empty() ? 0 : 1);
    if (!floor.tint.empty()) {
        gl.ActiveTexture(GL_TEXTURE0 + tint_unit);
        gl.BindTexture(GL_TEXTURE_2D, tint_texture_.id());
    }
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, floor_texture_.id());
    blend_over(gl, false);
    upload_vertices(vertices);
    gl.DrawArrays(GL_TRIANGLE_STRIP, 0, static_cast<GLsizei>(vertices.size()));
    gl.BindVertexArray(0);
    check_gl(gl, "drawing the floor");
}

}  // namespace vvr::gl
