#include "cli/app/series.h"

#include <utility>

#include "cli/app/compose.h"
#include "cli/app/render_thread.h"
#include "cli/app/window.h"

namespace vvr::app {

namespace {

/// The phase of the tracelines' texture: stripes move from picture to picture (§6.2.1), faster in stills, which are
/// few.
double phase_of(const Plan& plan, std::int64_t brick, std::int64_t pictures) {
    constexpr std::int64_t stills = 8;  // number of stills over which the texture moves by one stripe
    if (!plan.job.output.slide) return static_cast<double>(brick % stills) / stills;
    return static_cast<double>(pictures % default_animation) / default_animation;
}

}  // namespace

Outcome render_series(const Plan& plan, fields::FieldSource& source, Observer& observer, const PictureSink& sink) {
    RunFacts run;
    RenderThread thread;
    thread.run([&](Drawing& drawing) {
        open_context(plan, drawing, observer);
        run.describe(*drawing.context);
        make_renderer(plan, gl::RenderOptions{}.tile_samples, drawing);
    });
    Composition composed;
    bool all_still = true;
    bool frames_missing = false;
    Window window(plan, source, [&](const Observation& seen, std::int64_t brick) {
        run.stages.end("fields");
        composed = compose(plan, seen);
        run.stages.end("scene");
        all_still = all_still && composed.still;
        frames_missing = frames_missing || composed.frames_missing;
        thread.run([&](Drawing& drawing) { show(plan, composed, seen, drawing); });
        for (int i = 0; i < plan.products.pictures; ++i) {
            FinishedPicture picture{static_cast<int>(brick), {}, {plan, seen, composed, run}};
            thread.run([&](Drawing& drawing) {
                picture.picture = draw(plan, composed, seen, drawing, phase_of(plan, brick, run.pictures));
            });
            run.stages.end("draw");
            ++run.pictures;
            sink(std::move(picture));
            run.stages.end("write");
        }
    });
    std::int64_t frames = 0;
    fields::FieldSummary summary =
        source.read(window.needs(), [&](const video::SharedFrame& frame, const fields::Field& field) {
            window.add(frame, field);
            observer.frames(++frames, plan.clip.expected_frames);
        });
    Observation seen = window.finish(source, std::move(summary));
    run.stages.end("fields");
    composed.still = all_still;
    composed.frames_missing = frames_missing;
    return {std::move(seen), std::move(composed), std::move(run)};
}

}  // namespace vvr::app
