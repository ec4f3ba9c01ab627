#include "gl/flow_geometry.h"

#include <cstddef>

#include "gl/attribute.h"
#include "gl/check.h"
#include "gl/light.h"
#include "gl/program_sources.h"

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

}  // namespace vvr::gl
