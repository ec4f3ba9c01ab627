#pragma once

#include <optional>
#include <span>

#include "core/scene/flow_geometry.h"
#include "core/space/camera.h"
#include "gl/program.h"
#include "gl/render_options.h"

namespace vvr::gl {

/// Draws an arrow glyph at each seed by instancing, as opaque geometry (§5.2, §6.2).
class FlowGeometry {
  public:
    explicit FlowGeometry(const GladGLContext& gl);

    /// Replaces the arrows.
    void upload(std::span<const scene::Glyph> glyphs);

    void draw(const space::Camera& camera, const GlyphStyle& style) const;

    /// Draws into a PixelDataTarget.
    void draw_pixel_data(const space::Camera& camera, const GlyphStyle& style);

  private:
    /// With the program in use.
    void draw_glyphs(const Program& program, const space::Camera& camera, const GlyphStyle& style) const;

    const GladGLContext* gl_;
    Program program_;
    std::optional<Program> pixel_data_program_;  ///< compiled on first use
    GlVertexArray vertex_array_;
    GlBuffer mesh_;
    GlBuffer indices_;
    GlBuffer instances_;
    GLsizei index_count_ = 0;
    GLsizei glyph_count_ = 0;
};

/// Draws tracelines as camera-facing strips, shaded as tubes, with the zebra texture moving along them (§6.2.1). All
/// stripes have the same length, so longer lines have more of them.
class TracelineStrips {
  public:
    explicit TracelineStrips(const GladGLContext& gl);

    /// Replaces the lines.
    void upload(const scene::Tracelines& lines);

    /// \param phase of the zebra texture, in stripes
    void draw(const space::Camera& camera, Size picture, const TraceStyle& style, const GlyphStyle& colours,
              double phase) const;

    /// Draws into a PixelDataTarget.
    void draw_pixel_data(const space::Camera& camera, Size picture, const TraceStyle& style, const GlyphStyle& colours);

  private:
    /// With the program in use.
    void draw_lines(const Program& program, const space::Camera& camera, Size picture, const TraceStyle& style,
                    const GlyphStyle& colours) const;

    const GladGLContext* gl_;
    Program program_;
    std::optional<Program> pixel_data_program_;  ///< compiled on first use
    GlTexture zebra_;
    GlVertexArray vertex_array_;
    GlBuffer corners_;
    GlBuffer points_;
    GLsizei segment_count_ = 0;
};

}  // namespace vvr::gl
