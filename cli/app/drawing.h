#pragma once

#include <cstdint>
#include <memory>

#include "cli/app/annotate.h"
#include "cli/app/job.h"
#include "cli/app/observer.h"
#include "gl/context.h"
#include "gl/renderer.h"

namespace vvr::app {

/// What draws the pictures of a job. It is made, used and closed on one thread (cli/app/render_thread.h).
struct Drawing {
    std::shared_ptr<gl::Context> context;
    std::unique_ptr<space::Layout> layout;
    Framing framing;
    std::unique_ptr<gl::Renderer> renderer;
    std::unique_ptr<gl::BrickWindow> window;
};

/// Opens a context that can draw what the job asks for. It is closed before the observer goes.
/// \throws Error backend, limit
void open_context(const RenderJob& job, Drawing& drawing, Observer& observer);

/// Makes all that does not depend on the clip's fields, in a drawing that has a context.
/// \param tile_samples as in RenderOptions: more take more memory
/// \throws Error backend, limit, io
void make_renderer(const RenderJob& job, Size field_size, std::int64_t tile_samples, Drawing& drawing);

/// Half of the diagonal of the largest pixel that shows the volume, in P-space units: the margin of a BrickWindow's
/// cells.
double half_pixel(const RenderJob& job, const Drawing& drawing);

/// Draws something small, so that the first real picture finds its shaders compiled. The drawing has a renderer.
void warm_up(const RenderJob& job, const Drawing& drawing);

}  // namespace vvr::app
