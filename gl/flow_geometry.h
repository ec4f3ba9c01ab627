#pragma once

#include <optional>
#include <span>

#include "core/scene/glyph.h"
#include "core/space/camera.h"
#include "gl/program.h"

namespace vvr {

/// How arrows look.
struct GlyphStyle {
    float thickness = 0.05F;            ///< P-space units per unit of the reference glyph's radius
    glm::vec2 speed_range{0.3F, 6.0F};  ///< pixels per frame at the ends of the colour scale
    glm::vec3 slow_colour{0.98F, 0.72F, 0.20F};
    glm::vec3 fast_colour{0.84F, 0.16F, 0.10F};
};

/// Draws one reference glyph at every seed, instanced, as opaque geometry (§5.2, §6.2).
class FlowGeometry {
  public:
    explicit FlowGeometry(const GladGLContext& gl);

    /// Replaces the arrows that are drawn.
    void upload(std::span<const Glyph> glyphs);

    void draw(const Camera& camera, const GlyphStyle& style) const;

    /// Draws into a PixelDataTarget.
    void draw_pixel_data(const Camera& camera, const GlyphStyle& style);

  private:
    /// With the program in use.
    void draw_glyphs(const Program& program, const Camera& camera, const GlyphStyle& style) const;

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

}  // namespace vvr
