#pragma once

#include <span>

#include "core/scene/scene.h"
#include "core/space/camera.h"
#include "gl/program.h"

namespace vvr {

/// Draws what explains the volume: lines, and frames that stand in it.
class Annotations {
  public:
    explicit Annotations(const GladGLContext& gl);

    /// Lines of `width` pixels of a picture of size `picture`.
    void draw_lines(std::span<const Segment> lines, const Camera& camera, double width, Size picture);

    /// A frame standing at its time; opaque ones write depth.
    void draw_frame(const StandingFrame& frame, const Layout& layout, const Camera& camera);

  private:
    const GladGLContext* gl_;
    Program line_program_;
    GlVertexArray line_array_;
    GlBuffer corners_;
    GlBuffer segments_;
    Program picture_program_;
    GlVertexArray picture_array_;
    GlBuffer picture_vertices_;
};

}  // namespace vvr
