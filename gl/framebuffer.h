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

/// \throws Error limit if the driver can't make framebuffers with that many samples per pixel
void check_samples(const GladGLContext& gl, int samples);

/// Splits a picture into tiles of at most `pixels` pixels: bands of whole rows if rows are short enough.
std::vector<PixelBox> cut_tiles(Size picture, std::int64_t pixels);

/// Copies the lower left corner of the bound framebuffer to a tile of a picture, top row first.
void read_pixels(const GladGLContext& gl, const PixelBox& tile, Plane<glm::vec4>& picture);

/// Colour and depth buffers. Colour is 32-bit float: blending hundreds of faint slices in half floats would round each
/// of them down, by a tenth in sum. With the software rasteriser it costs no time.
class Framebuffer {
  public:
    /// \param samples per pixel; 1 = no antialiasing
    /// \throws Error limit if the driver doesn't support the size or the samples, backend if the framebuffer is
    ///     incomplete
    Framebuffer(const GladGLContext& gl, Size size, int samples);

    /// Makes the lower left `size` of the framebuffer the drawing target.
    void bind(Size size) const;

    /// Copies its lower left corner to a tile of a picture: premultiplied RGBA, top row first.
    void read(const PixelBox& tile, Plane<glm::vec4>& picture) const;

  private:
    /// The drawing target. If it is multisampled, shaders can sample it, but it can't be read back.
    struct Drawn {
        GlFramebuffer framebuffer;
        GlTexture samples;
        GlRenderbuffer colour;  ///< used with one sample per pixel
        GlRenderbuffer depth;
    };
    /// The multisample resolve.
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

/// Per-pixel data of a picture that is drawn back to front, one sample per pixel: the weight, frame, depth and event of
/// the strongest contribution so far, and the total opacity. Fixed-function blending can't select by weight, so each
/// step reads what has been drawn: with GL_EXT_shader_framebuffer_fetch from the pixel that it draws; without it, it
/// draws into a second texture and copies that back.
class PixelDataTarget {
  public:
    /// \throws Error backend if the driver can't render to such textures
    PixelDataTarget(const GladGLContext& gl, Size size);

    /// Clears the target. Next, draw opaque geometry with glsl/pixel_data.frag.
    void begin(Size size) const;

    /// Clears the data but not the depth. Next, draw what lies in front of the opaque geometry.
    void begin_before_geometry() const;

    /// Whether a draw may cover a pixel several times, back to front.
    bool fetches() const { return data_.size() == 1; }

    /// Draws over everything drawn so far. Unless the target `fetches`, `draw` must cover each pixel at most once.
    /// \param program in use, with glsl/pixel_data_over.glsl
    void draw_over(const Program& program, const std::function<void()>& draw) const;

    /// Weight, frame, depth and opacity of the lower left `size`, top row first.
    Plane<glm::vec4> read(Size size) const;

    /// The event number of each pixel, in the first channel.
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
    std::vector<Data> data_;  ///< the data, and a second buffer for drivers that can't fetch
    GlRenderbuffer depth_;
};

}  // namespace vvr::gl
