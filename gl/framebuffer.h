#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/pixel_box.h"
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

}  // namespace vvr::gl
