#include "cli/app/render_time.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "cli/app/render.h"
#include "cli/plan/observer.h"

namespace vvr::app {

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
