#pragma once

#include <cstdint>

#include "cli/observe/window.h"
#include "cli/plan/observer.h"
#include "cli/plan/plan.h"
#include "cli/plan/settings.h"
#include "cli/write/write.h"

/// The whole application: a job as input; pictures, a page, a report and the comparison with a golden picture as
/// output.
namespace vvr::app {

/// Facts about a run for the caller.
struct RenderSummary {
    media::VideoInfo info;
    std::int64_t frames = 0;
    std::int64_t damaged = 0;  ///< packets that could not be decoded
    ShownEvents events{};      ///< empty unless listed
    Size field_size{};         ///< the events' pixels are those of the field
};

/// Runs a whole job: plan, observe, compose, draw, write.
/// \param on_picture called for each picture before it is written, even if no file is wanted; may be empty
/// \throws Error of every kind; `differs` after everything has been written
RenderSummary render(const RenderJob& job, Observer& observer, const PictureCallback& on_picture = {});

/// The result of a run.
struct Outcome {
    Observation seen;
    Composition composed;  ///< of the last picture
    RunFacts run;
};

/// Draws one picture of a whole clip, or `products.pictures` of them; none if only a report is wanted. These differ
/// only in the phase of the tracelines' texture and form a loop.
/// \throws Error backend before a long clip is read, if OpenGL can't draw; limit, not_video, io, usage
Outcome render_clip(const Plan& plan, fields::FieldSource& source, Observer& observer, const PictureSink& sink,
                    const FrameWatch& watch = {});

/// Draws a series: one picture per brick of the clip, when the brick has entered the window. Picture j shows bricks j -
/// k + 1 to j; the first pictures show fewer, from the start of the horseshoe. Time scale and camera are the same in
/// all pictures. Memory depends only on the window.
/// \param sink called with each picture and its brick's number
/// \param ended called with each event that has ended; may be empty. It needs a plan that finds objects
/// \returns the last window's observation, with the frames, damage and events of the whole clip
Outcome render_series(const Plan& plan, fields::FieldSource& source, Observer& observer, const PictureSink& sink,
                      const EndedSink& ended = {}, const FrameWatch& watch = {});

/// How long a render takes on this machine, as measured on the first seconds of the clip.
struct RenderTime {
    double frames_per_second = 0;  ///< read, with fields and events
    double seconds = 0;            ///< of the whole picture, without a page; 0 = the clip's length is unknown
    std::int64_t measured = 0;     ///< frames that were read for this
};

/// Draws a picture of the first seconds of a clip, and writes it nowhere.
/// \param plan of the whole clip
/// \throws Error of every kind
RenderTime measure_render(const RenderJob& job, const Plan& plan);

}  // namespace vvr::app
