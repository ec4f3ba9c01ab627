#pragma once

#include <array>
#include <functional>

#include <glm/glm.hpp>

#include "core/plane.h"
#include "gl/program.h"

namespace vvr {

/// The state of what is seen in each pixel while a picture is drawn back to front, one sample a pixel: the weight of
/// what contributes most so far, its frame and depth, and the opacity of all. No blending knows the larger of two
/// weights, so each step reads the state and draws the next one beside it, and is then copied back.
class SeenTarget {
  public:
    /// \throws Error backend when the driver can't draw into such states
    SeenTarget(const GladGLContext& gl, Size size);

    /// Begins with nothing seen. Opaque geometry is drawn into the target now, with glsl/seen.frag.
    void begin(Size size) const;

    /// Begins anew with what lies before the opaque geometry, which goes on hiding what is behind it.
    void begin_before_geometry() const;

    /// Draws something before all that has been drawn. It covers a pixel at most once.
    /// \param program in use, with glsl/seen_over.glsl
    void draw_over(const Program& program, const std::function<void()>& draw) const;

    /// The states of the lower left `size`, top row first.
    Plane<glm::vec4> read(Size size) const;

  private:
    struct State {
        GlFramebuffer framebuffer;
        GlTexture texture;
    };

    const GladGLContext* gl_;
    std::array<State, 2> states_;  ///< the state, and where the next one is drawn
    GlRenderbuffer depth_;
};

}  // namespace vvr
