#pragma once

#include <optional>
#include <span>

#include "core/scene/glyph.h"
#include "core/space/camera.h"
#include "gl/program.h"

namespace vvr {

/// How arrows look.
struct GlyphStyle {
    float thickness = 0.05F;            ///< P-space units a unit of the reference glyph's radius
    glm::vec2 speed_range{0.3F, 6.0F};  ///< pixels a frame at the ends of the colour scale
    glm::vec3 slow_colour{0.98F, 0.72F, 0.20F};
    glm::vec3 fast_colour{0.84F, 0.16F, 0.10F};
};

/// Where the light of the flow geometry comes from: above and behind the viewer's left shoulder.
glm::vec3 to_light(const Camera& camera);

/// Draws one reference glyph at every seed, instanced, as opaque geometry (§5.2, §6.2).
class FlowGeometry {
  public:
    explicit FlowGeometry(const GladGLContext& gl);

    /// Replaces the arrows that are drawn.
    void upload(std::span<const Glyph> glyphs);

    void draw(const Camera& camera, const GlyphStyle& style) const { draw_with(program_, camera, style); }

    /// The same into a target of what is seen.
    void draw_seen(const Camera& camera, const GlyphStyle& style);

  private:
    void draw_with(const Program& program, const Camera& camera, const GlyphStyle& style) const;

    const GladGLContext* gl_;
    Program program_;
    std::optional<Program> seen_program_;  ///< made when it is first asked for
    GlVertexArray vertex_array_;
    GlBuffer mesh_;
    GlBuffer indices_;
    GlBuffer instances_;
    GLsizei index_count_ = 0;
    GLsizei glyph_count_ = 0;
};

}  // namespace vvr
