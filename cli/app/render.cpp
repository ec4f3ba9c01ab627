#include "cli/app/render.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "cli/compose/compose.h"
#include "cli/compose/page_content.h"
#include "cli/draw/draw.h"
#include "cli/observe/identify.h"
#include "cli/plan/input.h"
#include "cli/plan/make_plan.h"
#include "cli/write/golden.h"
#include "core/base/text.h"
#include "core/image/text.h"
#include "core/media/input.h"
#include "core/page/html.h"

namespace vvr::app {

namespace {

// Shorter clips are read within seconds, so reading begins before OpenGL is known to work.
constexpr std::int64_t soon_read = 5000;
// For longer clips, create the renderer after reading: saving memory is worth the extra time.
constexpr std::int64_t long_read = 100'000;

/// The phase of the tracelines' texture: stripes move from picture to picture (§6.2.1), faster in stills, which are
/// few.
double phase_of(const Plan& plan, std::int64_t brick, std::int64_t pictures) {
    constexpr std::int64_t stills = 8;  // number of stills over which the texture moves by one stripe
    if (!plan.output.files.slide) return static_cast<double>(brick % stills) / stills;
    return static_cast<double>(pictures % default_animation) / default_animation;
}

std::vector<page::PageContent::Segment> pieces_for_page(const PagePlan& page, const KeptEvents& kept) {
    std::vector<page::PageContent::Segment> pieces;
    for (const WrittenPiece& piece : kept.pieces) {
        pieces.push_back({page::relative_url(page.path, page.pieces / piece.file), piece.facts.begin,
                          piece.facts.until - piece.facts.begin});
    }
    return pieces;
}

/// A run for a report or tables alone. It draws nothing, so it opens no OpenGL, which costs more than a short clip.
Outcome describe_clip(const Plan& plan, fields::FieldSource& source, Observer& observer) {
    RunFacts run;
    Observation seen = observe(plan, source, observer);
    run.stages.end("fields");
    Composition composed = compose(plan, seen);
    run.note(composed);
    run.stages.end("scene");
    return {std::move(seen), std::move(composed), std::move(run)};
}

}  // namespace

Outcome render_clip(const Plan& plan, fields::FieldSource& source, Observer& observer, const PictureSink& sink,
                    const FrameWatch& watch) {
    if (plan.output.pictures == 0) return describe_clip(plan, source, observer);
    RunFacts run;  // starts the timing of stages
    const std::int64_t expected = plan.read.clip.expected_frames;
    const bool is_long = expected > long_read;
    RenderThread thread;
    auto opened = thread.start([&](GlSession& session) { open_context(plan.look, session, observer); });
    // Loading the libraries and compiling the shaders uses a second core while the clip is read.
    if (!is_long) {
        thread.start([&](GlSession& session) {
            make_renderer(plan.look, gl::RenderOptions{}.tile_samples, session);
            const Sample sample = compose_sample(plan);
            warm_up(plan.look, sample.composed, sample.seen, session);
        });
    }
    if (expected == 0 || expected > soon_read) opened.get();
    Observation seen = observe(plan, source, observer, watch);
    run.stages.end("fields");
    observer.drawing(0, 1);
    thread.run([&](GlSession& session) {
        if (is_long) make_renderer(plan.look, gl::RenderOptions{}.tile_samples / 4, session);
        run.describe(*session.context);
    });
    Composition composed = compose(plan, seen);
    run.note(composed);
    run.stages.end("scene");
    thread.run([&](GlSession& session) { show(plan.look, composed, seen, session); });
    const int pictures = plan.output.pictures;
    for (int i = 0; i < pictures; ++i) {
        FinishedPicture picture{i, {}, {plan, seen, composed, run}};
        thread.run([&](GlSession& session) {
            picture.picture = draw(plan.look, seen, session, observer, static_cast<double>(i) / pictures);
            if (i + 1 == pictures) close(session);
        });
        run.stages.end("draw");
        run.pictures = i + 1;
        sink(std::move(picture));
        run.stages.end("write");
    }
    return {std::move(seen), std::move(composed), std::move(run)};
}

Outcome render_series(const Plan& plan, fields::FieldSource& source, Observer& observer, const PictureSink& sink,
                      const EndedSink& ended, const FrameWatch& watch) {
    RunFacts run;
    RenderThread thread;
    thread.run([&](GlSession& session) {
        open_context(plan.look, session, observer);
        run.describe(*session.context);
        make_renderer(plan.look, gl::RenderOptions{}.tile_samples, session);
    });
    Composition composed;
    Observer unseen;  // the progress is that of the frames, between which the pictures are drawn
    const auto full = [&](const Observation& seen, std::int64_t brick) {
        run.stages.end("fields");
        composed = compose(plan, seen);
        run.note(composed);
        run.stages.end("scene");
        thread.run([&](GlSession& session) { show(plan.look, composed, seen, session); });
        for (int i = 0; i < plan.output.pictures; ++i) {
            FinishedPicture picture{static_cast<int>(brick), {}, {plan, seen, composed, run}};
            thread.run([&](GlSession& session) {
                picture.picture = draw(plan.look, seen, session, unseen, phase_of(plan, brick, run.pictures));
            });
            run.stages.end("draw");
            ++run.pictures;
            sink(std::move(picture));
            run.stages.end("write");
        }
    };
    Window window(plan, source, full, ended);
    std::int64_t frames = 0;
    if (watch.begin) watch.begin(source);
    fields::FieldSummary summary =
        source.read(window.needs(), [&](const media::SharedFrame& frame, const fields::Field& field) {
            if (watch.add) watch.add(frame, field);
            window.add(frame, field);
            observer.frames(++frames, plan.read.clip.expected_frames);
        });
    Observation seen = window.finish(source, std::move(summary));
    run.stages.end("fields");
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
    Writer writer(files, on_picture, observer);
    check_memory(plan.volume.extent);

    const bool has_page = !page_of(job.output).empty();
    page::MomentWatch moments(has_page);
    FrameWatch watch;
    if (plan.field.keeps_moments) {
        watch = {[&](const fields::FieldSource& source) { moments.begin(source); },
                 [&](const media::SharedFrame& frame, const fields::Field& field) { moments.add(frame, field); }};
    }
    KeptEvents kept;
    const PictureSink write = [&](FinishedPicture&& picture) {
        const Observation& seen = picture.context.seen;
        if (!plan.output.files.pieces.folder.empty()) kept = keep_events(plan, seen, observer);
        Writer::Kept beside;
        if (plan.field.keeps_moments) beside.moments = moments.take();
        if (has_page) {
            beside.page = page_content(plan, seen, picture.context.composed);
            beside.page.pieces = pieces_for_page(plan.page, kept);
        }
        writer.write(std::move(picture), std::move(beside));
    };
    Outcome done = plan.volume.series ? render_series(plan, *fields.source, observer, write, {}, watch)
                                      : render_clip(plan, *fields.source, observer, write, watch);
    require_frames(done.seen.summary.frames, done.seen.info);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    writer.finish({plan, done.seen, done.composed, done.run}, took.count(), kept);
    return {done.seen.info, done.seen.summary.frames, done.seen.summary.damaged,
            std::move(done.seen.events).value_or(ShownEvents{}), plan.read.clip.field_size};
}

namespace {

/// Thrown when a part of a large picture has shown how long all of it takes.
struct Enough {};

/// Notes when the frames came, and how long drawing takes.
class Stopwatch final : public Observer {
  public:
    using Clock = std::chrono::steady_clock;

    void frames(std::int64_t done, std::int64_t /*expected*/) override {
        last = Clock::now();
        if (done == 1) first = last;
        frames_read = done;
    }

    /// \throws Enough
    void drawing(std::int64_t done, std::int64_t parts) override {
        constexpr double patience = 1.5;  // seconds
        if (done == 0) begun = Clock::now();
        const double took = seconds_between(begun, Clock::now());
        if (done == 0 || done == parts || took < patience) return;
        not_drawn = took * static_cast<double>(parts - done) / static_cast<double>(done);
        throw Enough();
    }

    static double seconds_between(Clock::time_point from, Clock::time_point to) {
        return std::chrono::duration<double>(to - from).count();
    }

    std::int64_t frames_read = 0;
    Clock::time_point first{};
    Clock::time_point last{};
    Clock::time_point begun{};
    double not_drawn = 0;  ///< seconds that the rest of the picture would take
};

/// The first seconds of a span; more of them where frames are rare.
media::FrameSpan begin_of(media::FrameSpan span, double rate) {
    constexpr double least_seconds = 2;
    constexpr double least_frames = 50;
    const double frames_per_second = rate > 0 ? rate : 25;
    const double seconds = std::max(least_seconds, least_frames / frames_per_second);
    if (span.first > 0) {
        const std::int64_t stop = span.first + std::llround(seconds * frames_per_second);
        span.stop = std::min(stop, span.stop.value_or(stop));
        return span;
    }
    const double start = span.parts.empty() ? span.start : std::max(span.start, span.parts.front().begin);
    const double end = start + seconds;
    span.end = std::min(end, span.end.value_or(end));
    return span;
}

}  // namespace

RenderTime measure_render(const RenderJob& job, const Plan& plan) {
    RenderJob part = job;
    part.fields.span = begin_of(plan.read.clip.span, plan.read.clip.info.rate);
    Stopwatch watch;
    const auto begin = Stopwatch::Clock::now();
    try {
        render(part, watch, [](const image::Picture&, const image::Metadata&) {});
    } catch (const Enough&) {
    }
    const double all = Stopwatch::seconds_between(begin, Stopwatch::Clock::now()) + watch.not_drawn;
    const double reading = Stopwatch::seconds_between(watch.first, watch.last);
    RenderTime time{.measured = watch.frames_read};
    if (watch.frames_read < 2 || reading <= 0) return time;
    time.frames_per_second = static_cast<double>(watch.frames_read - 1) / reading;
    if (plan.volume.extent.frames > 0)
        time.seconds = all - reading + static_cast<double>(plan.volume.extent.frames) / time.frames_per_second;
    return time;
}

}  // namespace vvr::app
