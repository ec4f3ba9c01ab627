#pragma once

#include <optional>
#include <span>

#include "core/scene/scene.h"
#include "core/space/camera.h"
#include "gl/program.h"
#include "gl/seen_target.h"

namespace vvr {

/// Draws what explains the volume: lines, and frames that stand in it.
class Annotations {
  public:
    explicit Annotations(const GladGLContext& gl);

    /// Lines of `width` pixels of a picture of size `picture`.
    void draw_lines(std::span<const Segment> lines, const Camera& camera, double width, Size picture);

    /// A frame standing at its time; opaque ones write depth.
    void draw_frame(const StandingFrame& frame, const Layout& layout, const Camera& camera);

    /// The same into a target of what is seen.
    void draw_frame_seen(const StandingFrame& frame, const Layout& layout, const Camera& camera,
                         const SeenTarget& target);

    /// The shadow on the volume's floor.
    void draw_floor(const FloorShadow& floor, const Layout& layout, const Camera& camera);

  private:
    struct PictureVertex {
        glm::vec3 p;
        glm::vec2 at;
    };

    void upload_frame(const StandingFrame& frame, const Layout& layout);
    void upload_vertices(std::span<const PictureVertex> vertices);

    const GladGLContext* gl_;
    Program line_program_;
    GlVertexArray line_array_;
    GlBuffer corners_;
    GlBuffer segments_;
    Program picture_program_;
    std::optional<Program> floor_program_;  ///< made when it is first asked for
    std::optional<Program> seen_program_;   ///< the same
    GlVertexArray picture_array_;
    GlBuffer picture_vertices_;
};

}  // namespace vvr
