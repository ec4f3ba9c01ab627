#pragma once

#include <array>
#include <functional>

#include <glm/glm.hpp>

#include "core/base/plane.h"
#include "gl/program.h"

namespace vvr::gl {

/// Pixel data while a picture is drawn back to front, one sample per pixel: the weight of what contributes most so far,
/// its frame and depth, and the opacity of all; and the event that it belongs to. Blending cannot select by weight, so
/// each step reads what has been drawn. With GL_ARB_texture_barrier that is the texture that it draws into; without, it
/// draws into another, which is then copied back.
class PixelDataTarget {
  public:
    /// \throws Error backend when the driver can't draw into such textures
    PixelDataTarget(const GladGLContext& gl, Size size);

    /// Clears the target. Opaque geometry is drawn into it next, with glsl/pixel_data.frag.
    void begin(Size size) const;

    /// Clears the data but not the depth: next comes what lies in front of the opaque geometry.
    void begin_before_geometry() const;

    /// Draws something in front of all that has been drawn. It covers a pixel at most once.
    /// \param program in use, with glsl/pixel_data_over.glsl
    void draw_over(const Program& program, const std::function<void()>& draw) const;

    /// The data of the lower left `size`: weight, frame, depth, opacity; top row first.
    Plane<glm::vec4> read(Size size) const;

    /// The events of the same pixels, as the first of four.
    Plane<glm::vec4> read_objects(Size size) const;

  private:
    struct Data {
        GlFramebuffer framebuffer;
        GlTexture texture;
        GlTexture objects;
    };

    void read_from(const Data& data) const;
    Plane<glm::vec4> read_attachment(GLenum attachment, Size size) const;

    const GladGLContext* gl_;
    std::array<Data, 2> data_;  ///< the data, and what the next step draws into
    GlRenderbuffer depth_;
};

}  // namespace vvr::gl
