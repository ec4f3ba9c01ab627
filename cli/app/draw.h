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

// From a composition to its picture. All of it is done on the thread that owns the context (cli/app/render_thread.h).
namespace vvr::app {

/// What draws the pictures of a plan. It is made, used and closed on one thread.
struct Drawing {
    std::shared_ptr<gl::Context> context;
    std::unique_ptr<gl::Renderer> renderer;
    std::unique_ptr<gl::BrickWindow> window;
};

/// Opens a context that can draw what the plan asks for. It is closed before the observer goes.
/// \throws Error backend, limit
void open_context(const Plan& plan, Drawing& drawing, Observer& observer);

/// Makes all that does not depend on the clip's fields, in a drawing that has a context.
/// \param tile_samples as in RenderOptions: more take more memory
/// \throws Error backend, limit, io
void make_renderer(const Plan& plan, std::int64_t tile_samples, Drawing& drawing);

/// Draws something small, so that the first real picture finds its shaders compiled. The drawing has a renderer.
void warm_up(const Plan& plan, const Drawing& drawing);

/// Gives the renderer what a composition shows; pictures of it follow.
/// \param volume that was composed; it stays as it is until they have been drawn
void show(const Plan& plan, const Composition& composed, const Observation& seen, Drawing& drawing);

/// Draws what is shown, and letters it.
/// \param phase of the texture that moves along the tracelines, 0..1
image::Picture draw(const Plan& plan, const Composition& composed, const Observation& seen, Drawing& drawing,
                    double phase = 0);

/// OpenGL's memory is given back before the libraries that encode pictures take as much.
void close(Drawing& drawing);

}  // namespace vvr::app
