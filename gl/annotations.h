#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "core/space/camera.h"
#include "gl/program.h"
#include "gl/seen_target.h"

namespace vvr {

/// Draws what explains the volume: lines, and frames that stand in it.
class Annotations {
  public:
    explicit Annotations(const GladGLContext& gl);

    /// Takes the pictures that are drawn from now on.
    void upload(const FloorShadow& floor, std::span<const StandingFrame> frames);

    /// Lines of `width` pixels of a picture of size `picture`.
    void draw_lines(std::span<const Segment> lines, const Camera& camera, double width, Size picture);

    /// Frames standing at their times; opaque ones write depth.
    /// \param frames those that were uploaded
    void draw_frames(std::span<const StandingFrame> frames, const Layout& layout, const Camera& camera);

    /// One of them into a target of what is seen.
    void draw_frame_seen(const StandingFrame& frame, const Layout& layout, const Camera& camera,
                         const SeenTarget& target);

    /// The shadow on the volume's floor, the one that was uploaded.
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
    GlTexture floor_texture_;
    std::vector<GlTexture> frame_textures_;
    GlVertexArray picture_array_;
    GlBuffer picture_vertices_;
};

}  // namespace vvr
