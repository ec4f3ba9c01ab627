#pragma once

#include "cli/app/job.h"
#include "cli/app/observer.h"
#include "cli/app/write.h"

/// The application: a job in; pictures, a page, a report and the comparison with a golden picture out.
namespace vvr::app {

/// What a caller wants to know of a run.
struct RenderSummary {
    video::VideoInfo info;
    std::int64_t frames = 0;
    std::int64_t damaged = 0;  ///< packets that could not be decoded
};

/// Does a whole job: plan, observe, compose, draw, write.
/// \param taken called for each picture before it goes to its file; there is one even if no file is wanted.
///        Empty = nobody takes them
/// \throws Error of every kind; `differs` after everything has been written
RenderSummary render(const RenderJob& job, Observer& observer, const PictureTaker& taken = {});

/// Draws one picture of a whole clip, or `products.pictures` of them: then only the phase of the tracelines' texture
/// changes from one to the next, and the last is followed by the first.
/// \throws Error backend before a long clip is read, if OpenGL can't draw; limit, not_video, io, usage
Outcome render_clip(const Plan& plan, fields::FieldSource& source, Observer& observer, const PictureSink& sink);

}  // namespace vvr::app
