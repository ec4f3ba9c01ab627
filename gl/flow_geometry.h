#pragma once

#include <optional>
#include <span>

#include "core/scene/glyph.h"
#include "core/space/camera.h"
#include "gl/program.h"
#include "gl/render_options.h"

namespace vvr::gl {

/// Draws one reference glyph at every seed, instanced, as opaque geometry (§5.2, §6.2).
class FlowGeometry {
  public:
    explicit FlowGeometry(const GladGLContext& gl);

    /// Replaces the arrows that are drawn.
    void upload(std::span<const scene::Glyph> glyphs);

    void draw(const space::Camera& camera, const GlyphStyle& style) const;

    /// Draws into a PixelDataTarget.
    void draw_pixel_data(const space::Camera& camera, const GlyphStyle& style);

  private:
    /// With the program in use.
    void draw_glyphs(const Program& program, const space::Camera& camera, const GlyphStyle& style) const;

    const GladGLContext* gl_;
    Program program_;
    std::optional<Program> pixel_data_program_;  ///< made when it is first used
    GlVertexArray vertex_array_;
    GlBuffer mesh_;
    GlBuffer indices_;
    GlBuffer instances_;
    GLsizei index_count_ = 0;
    GLsizei glyph_count_ = 0;
};

}  // namespace vvr::gl
