#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "cli/app/compose.h"
#include "cli/app/observer.h"
#include "cli/app/plan.h"
#include "core/image/picture.h"
#include "gl/context.h"
#include "gl/renderer.h"

// Draws compositions. Call these functions on the thread that owns the context (cli/app/render_thread.h).
namespace vvr::app {

/// The OpenGL objects that draw the pictures of a plan. Create, use and close them on the same thread.
struct Drawing {
    std::shared_ptr<gl::Context> context;
    std::unique_ptr<gl::Renderer> renderer;
    std::unique_ptr<gl::BrickWindow> window;
};

/// Opens a context that can draw the plan. Close it before the observer is destroyed.
/// \throws Error backend, limit
void open_context(const Plan& plan, Drawing& drawing, Observer& observer);

/// Creates everything that does not depend on the clip's fields. The drawing must have a context.
/// \param tile_samples as in RenderOptions: a larger number uses more memory
/// \throws Error backend, limit, io
void make_renderer(const Plan& plan, std::int64_t tile_samples, Drawing& drawing);

/// Draws something small, so that the shaders are compiled before the first real picture. The drawing must have a
/// renderer.
void warm_up(const Plan& plan, const Drawing& drawing);

/// Passes a composition to the renderer, for the pictures that follow, and moves its scene there.
/// \param seen with the volume that was composed; it must not change until they are drawn
void show(const Plan& plan, Composition& composed, const Observation& seen, Drawing& drawing);

/// Draws the current composition with its text.
/// \param phase of the texture that moves along the tracelines, 0..1
image::Picture draw(const Plan& plan, const Composition& composed, const Observation& seen, Drawing& drawing,
                    double phase = 0);

/// Releases OpenGL's memory, before encoding needs as much.
void close(Drawing& drawing);

}  // namespace vvr::app
