#include "cli/app/render.h"

#include <chrono>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "cli/app/compose.h"
#include "cli/app/draw.h"
#include "cli/app/golden.h"
#include "cli/app/identify.h"
#include "cli/app/input.h"
#include "cli/app/plan.h"
#include "cli/app/settings.h"
#include "cli/app/window.h"
#include "core/base/text.h"
#include "core/image/text.h"
#include "core/media/input.h"

namespace vvr::app {

namespace {

// Shorter clips are read within seconds, so reading begins before OpenGL is known to work.
constexpr std::int64_t soon_read = 5000;
// For longer clips, create the renderer after reading: saving memory is worth the extra time.
constexpr std::int64_t long_read = 100'000;

/// Adds an observer of the fields that collects what a page and a still show.
page::WatchedFields* watch(const OutputOptions& output, OpenedFields& fields) {
    if (page_of(output).empty() && output.still.empty()) return nullptr;
    auto watched = std::make_unique<page::WatchedFields>(std::move(fields.source), !page_of(output).empty());
    page::WatchedFields* const watcher = watched.get();
    fields.source = std::move(watched);
    return watcher;
}

/// The phase of the tracelines' texture: stripes move from picture to picture (§6.2.1), faster in stills, which are
/// few.
double phase_of(const Plan& plan, std::int64_t brick, std::int64_t pictures) {
    constexpr std::int64_t stills = 8;  // number of stills over which the texture moves by one stripe
    if (!plan.job.output.slide) return static_cast<double>(brick % stills) / stills;
    return static_cast<double>(pictures % default_animation) / default_animation;
}

/// A run for a report or tables alone. It draws nothing, so it opens no OpenGL, which costs more than a short clip.
Outcome describe_clip(const Plan& plan, fields::FieldSource& source, Observer& observer) {
    RunFacts run;
    Observation seen = observe(plan, source, observer);
    run.stages.end("fields");
    Composition composed = compose(plan, seen);
    run.stages.end("scene");
    return {std::move(seen), std::move(composed), std::move(run)};
}

}  // namespace

Outcome render_clip(const Plan& plan, fields::FieldSource& source, Observer& observer, const PictureSink& sink) {
    if (plan.products.pictures == 0) return describe_clip(plan, source, observer);
    RunFacts run;  // starts the timing of stages
    const std::int64_t expected = plan.clip.expected_frames;
    const bool is_long = expected > long_read;
    RenderThread thread;
    auto opened = thread.start([&](Drawing& drawing) { open_context(plan, drawing, observer); });
    // Loading the libraries and compiling the shaders uses a second core while the clip is read.
    if (!is_long) {
        thread.start([&](Drawing& drawing) {
            make_renderer(plan, gl::RenderOptions{}.tile_samples, drawing);
            warm_up(plan, drawing);
        });
    }
    if (expected == 0 || expected > soon_read) opened.get();
    Observation seen = observe(plan, source, observer);
    run.stages.end("fields");
    observer.drawing(0, 1);
    thread.run([&](Drawing& drawing) {
        if (is_long) make_renderer(plan, gl::RenderOptions{}.tile_samples / 4, drawing);
        run.describe(*drawing.context);
    });
    Composition composed = compose(plan, seen);
    run.stages.end("scene");
    thread.run([&](Drawing& drawing) { show(plan, composed, seen, drawing); });
    const int pictures = plan.products.pictures;
    for (int i = 0; i < pictures; ++i) {
        FinishedPicture picture{i, {}, {plan, seen, composed, run}};
        thread.run([&](Drawing& drawing) {
            picture.picture = draw(plan, seen, drawing, observer, static_cast<double>(i) / pictures);
            if (i + 1 == pictures) close(drawing);
        });
        run.stages.end("draw");
        run.pictures = i + 1;
        sink(std::move(picture));
        run.stages.end("write");
    }
    return {std::move(seen), std::move(composed), std::move(run)};
}

Outcome render_series(const Plan& plan, fields::FieldSource& source, Observer& observer, const PictureSink& sink,
                      const EndedSink& ended) {
    RunFacts run;
    RenderThread thread;
    thread.run([&](Drawing& drawing) {
        open_context(plan, drawing, observer);
        run.describe(*drawing.context);
        make_renderer(plan, gl::RenderOptions{}.tile_samples, drawing);
    });
    Composition composed;
    Observer unseen;  // the progress is that of the frames, between which the pictures are drawn
    bool never_moves = true;
    bool frames_missing = false;
    const auto full = [&](const Observation& seen, std::int64_t brick) {
        run.stages.end("fields");
        composed = compose(plan, seen);
        run.stages.end("scene");
        never_moves = never_moves && composed.nothing_moves;
        frames_missing = frames_missing || composed.frames_missing;
        thread.run([&](Drawing& drawing) { show(plan, composed, seen, drawing); });
        for (int i = 0; i < plan.products.pictures; ++i) {
            FinishedPicture picture{static_cast<int>(brick), {}, {plan, seen, composed, run}};
            thread.run([&](Drawing& drawing) {
                picture.picture = draw(plan, seen, drawing, unseen, phase_of(plan, brick, run.pictures));
            });
            run.stages.end("draw");
            ++run.pictures;
            sink(std::move(picture));
            run.stages.end("write");
        }
    };
    Window window(plan, source, full, ended);
    std::int64_t frames = 0;
    fields::FieldSummary summary =
        source.read(window.needs(), [&](const media::SharedFrame& frame, const fields::Field& field) {
            window.add(frame, field);
            observer.frames(++frames, plan.clip.expected_frames);
        });
    Observation seen = window.finish(source, std::move(summary));
    run.stages.end("fields");
    composed.nothing_moves = never_moves;
    composed.frames_missing = frames_missing;
    return {std::move(seen), std::move(composed), std::move(run)};
}

RenderSummary render(const RenderJob& job, Observer& observer, const PictureCallback& on_picture) {
    validate(job);
    const auto begin = std::chrono::steady_clock::now();
    PictureOutput files(job.output, observer);
    check_golden_picture(job.output.golden);
    auto detector = open_detector(job.detector);
    // Nobody may answer for a long time.
    if (job.input.names.size() == 1 && media::is_url(job.input.names.front())) {
        observer.info(fmt::format("opening '{}'", redact_secrets(job.input.names.front())));
    }
    OpenedFields fields = open_fields(job);
    check_has_end(fields.source->info(), observer);
    const Plan plan =
        make_plan(job, fields.facts(), on_picture ? Purpose::caller : Purpose::files, std::move(detector));
    if (!fields.day_times.empty()) observer.info(fields.day_times);
    Writer writer(files, watch(job.output, fields), on_picture, observer);
    check_memory(plan.extent);

    const PictureSink write = [&writer](FinishedPicture&& picture) { writer.write(std::move(picture)); };
    Outcome done = plan.products.series ? render_series(plan, *fields.source, observer, write)
                                        : render_clip(plan, *fields.source, observer, write);
    require_frames(done.seen.summary.frames, done.seen.info);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    writer.finish({plan, done.seen, done.composed, done.run}, took.count());
    return {done.seen.info, done.seen.summary.frames, done.seen.summary.damaged,
            std::move(done.seen.events).value_or(ShownEvents{}), plan.clip.field_size};
}

}  // namespace vvr::app
