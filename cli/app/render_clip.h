#pragma once

#include <functional>

#include "cli/app/job.h"
#include "cli/app/observer.h"
#include "cli/app/report.h"
#include "core/fields/field_source.h"
#include "core/image/picture.h"

namespace vvr::app {

/// Takes each picture of a run with its number from 0 on, on one thread of the run's own.
using PictureSink = std::function<void(const RenderReport& so_far, int number, image::Picture&& picture)>;

/// Draws one picture of a whole clip, or `products.pictures` of them: then only the phase of the tracelines' texture
/// changes from one to the next, and the last is followed by the first.
/// \throws Error backend before a long clip is read, if OpenGL can't draw; limit, not_video, io, usage
RenderReport render_clip(const RenderJob& job, const Products& products, fields::FieldSource& source,
                         Observer& observer, const PictureSink& sink);

/// The events of a clip, as a report of `render_clip` lists them. Draws nothing.
std::vector<events::Event> find_events(const RenderJob& job, fields::FieldSource& source, Observer& observer);

}  // namespace vvr::app
