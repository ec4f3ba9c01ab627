#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "core/space/camera.h"
#include "gl/framebuffer.h"
#include "gl/program.h"

namespace vvr::gl {

/// Draws what explains the volume: lines, standing frames, and the volume's shadow on the floor.
class Annotations {
  public:
    explicit Annotations(const GladGLContext& gl);

    /// Replaces the textures of the floor and of the standing frames.
    void upload(const scene::FloorShadow& floor, std::span<const scene::StandingFrame> frames);

    /// \param width in pixels of a picture of size `picture`
    void draw_lines(std::span<const scene::LineSegment> lines, const space::Camera& camera, double width, Size picture);

    /// Draws an uploaded frame at its time. An opaque frame writes depth.
    /// \param number index of the frame in the last `upload`
    void draw_frame(const scene::StandingFrame& frame, std::size_t number, const space::Layout& layout,
                    const space::Camera& camera);

    /// Draws a frame into a pixel data target.
    void draw_frame_pixel_data(const scene::StandingFrame& frame, const space::Layout& layout,
                               const space::Camera& camera, const PixelDataTarget& target);

    /// \param floor as in the last `upload`
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
    std::optional<Program> floor_program_;       ///< compiled on first use
    std::optional<Program> pixel_data_program_;  ///< compiled on first use
    GlTexture floor_texture_;
    GlTexture tint_texture_;
    std::vector<GlTexture> frame_textures_;
    GlVertexArray picture_array_;
    GlBuffer picture_vertices_;
};

}  // namespace vvr::gl
