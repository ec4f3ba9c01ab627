#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"
#include "gl/objects.h"
#include "gl/program.h"

namespace vvr::gl {

/// \throws Error limit when the driver has no framebuffers with that many samples per pixel
void check_samples(const GladGLContext& gl, int samples);

/// Cuts a picture into tiles of at most `pixels` pixels: bands where whole rows are not too long.
std::vector<PixelBox> cut_tiles(Size picture, std::int64_t pixels);

/// Puts the lower left of the bound framebuffer into a tile of a picture, top row first.
void read_pixels(const GladGLContext& gl, const PixelBox& tile, Plane<glm::vec4>& picture);

/// Where a picture is drawn: colour and depth. The colour is in floats: hundreds of faint slices add up in it, and in
/// half floats each would be rounded down, a tenth of the picture by the end. It costs the software rasteriser no time.
class Framebuffer {
  public:
    /// \param samples for each pixel; 1 = no antialiasing
    /// \throws Error limit when the size or the samples are more than the driver takes, backend when it is incomplete
    Framebuffer(const GladGLContext& gl, Size size, int samples);

    /// Draws from now on into the lower left `size` of it.
    void bind(Size size) const;

    /// Puts its lower left, premultiplied RGBA, into a tile of a picture, top row first.
    void read(const PixelBox& tile, Plane<glm::vec4>& picture) const;

  private:
    /// What is drawn into: one with several samples per pixel can be sampled, but not read.
    struct Drawn {
        GlFramebuffer framebuffer;
        GlTexture samples;
        GlRenderbuffer colour;  ///< where a pixel has one sample
        GlRenderbuffer depth;
    };
    /// Where several samples become one.
    struct Resolved {
        GlFramebuffer framebuffer;
        GlRenderbuffer colour;
        GlVertexArray vertex_array;
        Program program;
    };
    Drawn make_drawn() const;
    Resolved make_resolved() const;
    void resolve(Size size) const;
    void check_complete(int samples) const;

    const GladGLContext* gl_;
    Size size_;
    int samples_;
    Drawn drawn_;
    std::optional<Resolved> resolved_;  ///< only with more than one sample
};

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
