#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "core/plane.h"
#include "gl/objects.h"

namespace vvr {

/// Where a picture is drawn: colour in half floats, as hundreds of faint slices add up in it, and depth.
class Framebuffer {
  public:
    /// \param samples for each pixel; 1 = no antialiasing
    /// \throws Error limit when the size or the samples are more than the driver takes, backend when it is incomplete
    Framebuffer(const GladGLContext& gl, Size size, int samples);

    void bind() const;

    /// The picture as premultiplied RGBA, top row first.
    Plane<glm::vec4> read() const;

  private:
    struct Target {
        GlFramebuffer framebuffer;
        GlRenderbuffer colour;
        GlRenderbuffer depth;
    };
    Target make_target(int samples) const;

    const GladGLContext* gl_;
    Size size_;
    int samples_;
    Target drawn_;
    Target resolved_;  ///< only with more than one sample
};

}  // namespace vvr
