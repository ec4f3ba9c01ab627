#pragma once

#include <span>

#include "core/scene/scene.h"
#include "core/space/camera.h"
#include "gl/program.h"

namespace vvr {

/// Draws what explains the volume: lines, and frames that stand in it.
class Annotations {
  public:
    Annotations(const GladGLContext& gl, Size picture);

    /// Opaque lines of `width` pixels.
    void draw_lines(std::span<const Segment> lines, const Camera& camera, double width);

    /// A frame standing at its time; opaque ones write depth.
    void draw_frame(const StandingFrame& frame, const Layout& layout, const Camera& camera);

  private:
    const GladGLContext* gl_;
    Size picture_;
    Program line_program_;
    GlVertexArray line_array_;
    GlBuffer corners_;
    GlBuffer segments_;
    Program picture_program_;
    GlVertexArray picture_array_;
    GlBuffer picture_vertices_;
};

}  // namespace vvr
