#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "core/space/camera.h"
#include "gl/framebuffer.h"
#include "gl/program.h"

namespace vvr::gl {

/// Draws what explains the volume: lines, frames that stand in it, and its shadow on the floor.
class Annotations {
  public:
    explicit Annotations(const GladGLContext& gl);

    /// Replaces the pictures that are drawn.
    void upload(const scene::FloorShadow& floor, std::span<const scene::StandingFrame> frames);

    /// \param width in pixels of a picture of size `picture`
    void draw_lines(std::span<const scene::LineSegment> lines, const space::Camera& camera, double width, Size picture);

    /// One of the frames that were uploaded, standing at its time; an opaque one writes depth.
    void draw_frame(const scene::StandingFrame& frame, std::size_t number, const space::Layout& layout,
                    const space::Camera& camera);

    /// Draws one of the frames into a target of pixel data.
    void draw_frame_pixel_data(const scene::StandingFrame& frame, const space::Layout& layout,
                               const space::Camera& camera, const PixelDataTarget& target);

    /// \param floor the one that was uploaded
    void draw_floor(const scene::FloorShadow& floor, const space::Layout& layout, const space::Camera& camera);

  private:
    struct PictureVertex {
        glm::vec3 p;
        glm::vec2 at;
    };

    void upload_frame(const scene::StandingFrame& frame, const space::Layout& layout);
    void upload_vertices(std::span<const PictureVertex> vertices);

    const GladGLContext* gl_;
    Program line_program_;
    GlVertexArray line_array_;
    GlBuffer corners_;
    GlBuffer segments_;
    Program picture_program_;
    std::optional<Program> floor_program_;       ///< made when it is first used
    std::optional<Program> pixel_data_program_;  ///< as `floor_program_`
    GlTexture floor_texture_;
    GlTexture tint_texture_;
    std::vector<GlTexture> frame_textures_;
    GlVertexArray picture_array_;
    GlBuffer picture_vertices_;
};

}  // namespace vvr::gl
