#include "gl/flow_geometry.h"

#include <array>
#include <cstddef>

#include "gl/context.h"
#include "gl/objects.h"

namespace vvr::gl {

FlowGeometry::FlowGeometry(const GladGLContext& gl)
    : gl_(&gl),
      program_(gl, arrow_program(Channels::colour)),
      vertex_array_(gl),
      mesh_(gl),
      indices_(gl),
      instances_(gl) {
    const scene::GlyphMesh mesh = scene::arrow_mesh();
    index_count_ = static_cast<GLsizei>(mesh.indices.size());
    gl.BindVertexArray(vertex_array_.id());

    gl.BindBuffer(GL_ARRAY_BUFFER, mesh_.id());
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(scene::GlyphVertex)),
                  mesh.vertices.data(), GL_STATIC_DRAW);
    set_attribute<scene::GlyphVertex>(gl, 0, 3, 0, Per::vertex);
    set_attribute<scene::GlyphVertex>(gl, 1, 3, offsetof(scene::GlyphVertex, normal), Per::vertex);

    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t)),
                  mesh.indices.data(), GL_STATIC_DRAW);

    gl.BindBuffer(GL_ARRAY_BUFFER, instances_.id());
    set_attribute<scene::Glyph>(gl, 2, 3, offsetof(scene::Glyph, from), Per::instance);
    set_attribute<scene::Glyph>(gl, 3, 3, offsetof(scene::Glyph, vector), Per::instance);
    set_attribute<scene::Glyph>(gl, 4, 1, offsetof(scene::Glyph, speed), Per::instance);
    set_attribute<scene::Glyph>(gl, 5, 1, offsetof(scene::Glyph, frame), Per::instance);
    gl.BindVertexArray(0);
    check_gl(gl, "setting up the flow geometry");
}

void FlowGeometry::upload(std::span<const scene::Glyph> glyphs) {
    glyph_count_ = static_cast<GLsizei>(glyphs.size());
    gl_->BindBuffer(GL_ARRAY_BUFFER, instances_.id());
    gl_->BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(glyphs.size_bytes()), glyphs.data(), GL_STATIC_DRAW);
    check_gl(*gl_, "uploading the arrows");
}

void FlowGeometry::draw(const space::Camera& camera, const GlyphStyle& style) const {
    program_.use();
    program_.set("slow_colour", style.slow_colour);
    program_.set("fast_colour", style.fast_colour);
    program_.set("to_light", to_light(camera));
    draw_glyphs(program_, camera, style);
}

void FlowGeometry::draw_pixel_data(const space::Camera& camera, const GlyphStyle& style) {
    if (!pixel_data_program_) pixel_data_program_ = Program(*gl_, arrow_program(Channels::pixel_data));
    pixel_data_program_->use();
    draw_glyphs(*pixel_data_program_, camera, style);
}

void FlowGeometry::draw_glyphs(const Program& program, const space::Camera& camera, const GlyphStyle& style) const {
    if (glyph_count_ == 0) return;
    const GladGLContext& gl = *gl_;
    program.set("clip_from_p", glm::mat4(camera.clip_from_p()));
    program.set("thickness", style.thickness);
    program.set("speed_range", style.speed_range);

    gl.Enable(GL_DEPTH_TEST);
    gl.DepthMask(GL_TRUE);
    gl.Disable(GL_BLEND);
    gl.BindVertexArray(vertex_array_.id());
    gl.DrawElementsInstanced(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr, glyph_count_);
    gl.BindVertexArray(0);
    check_gl(gl, "drawing the arrows");
}

TracelineStrips::TracelineStrips(const GladGLContext& gl)
    : gl_(&gl),
      program_(gl, traceline_program(Channels::colour)),
      zebra_(mipmapped_repeating_texture(gl, scene::zebra_texels())),
      vertex_array_(gl),
      corners_(gl),
      points_(gl) {
    gl.BindVertexArray(vertex_array_.id());
    constexpr std::array<glm::vec2, 4> corners = {glm::vec2{0, -1}, {1, -1}, {0, 1}, {1, 1}};
    gl.BindBuffer(GL_ARRAY_BUFFER, corners_.id());
    gl.BufferData(GL_ARRAY_BUFFER, sizeof(corners), corners.data(), GL_STATIC_DRAW);
    set_attribute<glm::vec2>(gl, 0, 2, 0, Per::vertex);

    // Each line segment is an instance that reads four consecutive points of the buffer: its two end points, and one
    // more on either side for the directions at its ends.
    gl.BindBuffer(GL_ARRAY_BUFFER, points_.id());
    const auto instance = [&](GLuint attribute, GLint size, std::size_t point, std::size_t offset) {
        set_attribute<scene::TraceVertex>(gl, attribute, size, point * sizeof(scene::TraceVertex) + offset,
                                          Per::instance);
    };
    static_assert(offsetof(scene::TraceVertex, along) == offsetof(scene::TraceVertex, p) + sizeof(glm::vec3));
    static_assert(offsetof(scene::TraceVertex, speed) == offsetof(scene::TraceVertex, length) + sizeof(float));
    static_assert(offsetof(scene::TraceVertex, frame) == offsetof(scene::TraceVertex, speed) + sizeof(float));
    for (std::size_t point = 0; point < 4; ++point) {
        instance(static_cast<GLuint>(1 + point), 4, point, offsetof(scene::TraceVertex, p));
    }
    instance(5, 3, 1, offsetof(scene::TraceVertex, length));
    instance(6, 3, 2, offsetof(scene::TraceVertex, length));
    gl.BindVertexArray(0);
    check_gl(gl, "setting up the tracelines");
}

void TracelineStrips::upload(const scene::Tracelines& lines) {
    segment_count_ = lines.empty() ? 0 : static_cast<GLsizei>(lines.size() - 1);
    if (segment_count_ == 0) return;
    // The first and last points are duplicated, so that the outermost segments have neighbours.
    const auto size = static_cast<GLsizeiptr>(sizeof(scene::TraceVertex));
    const auto bytes = static_cast<GLsizeiptr>(lines.size()) * size;
    gl_->BindBuffer(GL_ARRAY_BUFFER, points_.id());
    gl_->BufferData(GL_ARRAY_BUFFER, bytes + 2 * size, nullptr, GL_STATIC_DRAW);
    gl_->BufferSubData(GL_ARRAY_BUFFER, 0, size, &lines.front());
    gl_->BufferSubData(GL_ARRAY_BUFFER, size, bytes, lines.data());
    gl_->BufferSubData(GL_ARRAY_BUFFER, size + bytes, size, &lines.back());
    check_gl(*gl_, "uploading the tracelines");
}

void TracelineStrips::draw(const space::Camera& camera, Size picture, const TraceStyle& style,
                           const GlyphStyle& colours, double phase) const {
    program_.use();
    program_.set("shade", style.shade);
    program_.set("phase", static_cast<float>(phase));
    program_.set("slow_colour", colours.slow_colour);
    program_.set("fast_colour", colours.fast_colour);
    program_.set("to_light", to_light(camera));
    program_.set("zebra", 0);
    gl_->ActiveTexture(GL_TEXTURE0);
    gl_->BindTexture(GL_TEXTURE_1D, zebra_.id());
    draw_lines(program_, camera, picture, style, colours);
}

void TracelineStrips::draw_pixel_data(const space::Camera& camera, Size picture, const TraceStyle& style,
                                      const GlyphStyle& colours) {
    if (!pixel_data_program_) pixel_data_program_ = Program(*gl_, traceline_program(Channels::pixel_data));
    pixel_data_program_->use();
    draw_lines(*pixel_data_program_, camera, picture, style, colours);
}

void TracelineStrips::draw_lines(const Program& program, const space::Camera& camera, Size picture,
                                 const TraceStyle& style, const GlyphStyle& colours) const {
    if (segment_count_ == 0) return;
    const GladGLContext& gl = *gl_;
    program.set("clip_from_p", glm::mat4(camera.clip_from_p()));
    program.set("eye", glm::vec3(camera.eye));
    program.set("forward", glm::vec3(camera.forward));
    program.set("perspective", camera.perspective ? 1 : 0);
    program.set("half_width", style.width / 2);
    const double pixel = 2 / (camera.projection[1][1] * picture.height);
    program.set("min_width", static_cast<float>(style.min_width * pixel / 2));
    program.set("stripe_length", style.stripe_length);
    program.set("speed_range", colours.speed_range);

    gl.Enable(GL_DEPTH_TEST);
    gl.DepthMask(GL_TRUE);
    gl.Disable(GL_BLEND);
    gl.BindVertexArray(vertex_array_.id());
    gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, segment_count_);
    gl.BindVertexArray(0);
    check_gl(gl, "drawing the tracelines");
}

}  // namespace vvr::gl
