#include "cli/render/render_series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/render/build_scene.h"
#include "cli/render/render_thread.h"
#include "core/error.h"
#include "core/events/event_finder.h"

namespace vvr {

namespace {

constexpr double default_seconds = 10;
constexpr double default_frames = 100;  // where the rate is unknown

double frames_of_brick(const RenderJob& job, const FieldSource& source) {
    const VideoInfo& info = source.info();
    if (job.brick_frames > 0) return static_cast<double>(job.brick_frames);
    if (job.brick_seconds > 0) {
        if (info.rate > 0) return job.brick_seconds * info.rate;
        throw Error(ErrorKind::usage,
                    fmt::format("--brick {}s: '{}' does not tell how many frames it has a second; give "
                                "the length of a brick in frames, --brick {:.0f}",
                                job.brick_seconds, info.name, default_frames));
    }
    const double by_default = info.rate > 0 ? default_seconds * info.rate : default_frames;
    const auto expected = static_cast<double>(source.expected_frames());
    return expected > 0 ? std::min(by_default, std::ceil(expected / job.bricks)) : by_default;
}

/// The window while it slides: its volume, and what is drawn of it.
class Series {
  public:
    /// \param thread whose drawing has a renderer
    Series(const RenderJob& job, const FieldSource& source, RenderThread& thread, RenderReport begun,
           const PictureSink& sink)
        : job_(job),
          window_(sliding_window(job, source)),
          volume_(source.field_size(), std::max<std::int64_t>(2, window_.layers()), window_.step,
                  needs_of(job, source, window_.frames()).every),
          thread_(thread),
          pieces_of_brick_(std::ssize(cut_into_pieces(std::array{Brick{0, window_.brick_layers}}))),
          transfer_(job.transfer.scaled(job.opacity)),
          sink_(sink),
          report_(std::move(begun)) {
        volume_.set_span(window_.layers());
        if (job.show.contains("tracelines")) volume_.keep_flow();
        thread_.run([this](Drawing& drawing) {
            const int textures = textures_of(job_, window_.bricks * static_cast<int>(pieces_of_brick_));
            drawing.window =
                std::make_unique<BrickWindow>(drawing.context->gl(), *drawing.layout, window_.layers(), textures);
        });
        if (job.find_events) events_.emplace(source.field_size());
        report_.step = window_.step;
        report_.pictures = 0;
    }

    void add(const SharedFrame& frame, const Field& field) {
        if (begin_) fill_gap(field);
        if (!begin_) begin_ = {field.index, field.pts};
        if (volume_.frames() == window_.frames()) drop_oldest();
        if (events_) events_->add(field.scalar, {field.index, field.pts});
        volume_.add(field, volume_colour(job_, *frame));
        if (frames_of_newest_ == 0) first_of_bricks_.push_back(frame);
        last_ = frame;
        if (++frames_of_newest_ == window_.brick_frames()) complete_newest(Draw::yes);
    }

    /// After the last frame: the last brick may be shorter than the others. Frames and times are those of the clip, all
    /// else is that of the last window.
    RenderReport finish() {
        if (frames_of_newest_ > 0) complete_newest(Draw::yes);
        report_.stages.end("fields");
        report_.still = all_still_;
        if (events_) report_.events = events_->finish();
        if (begin_) {
            report_.first_frame = begin_->frame;
            report_.first_pts = begin_->seconds;
        }
        return report_;
    }

  private:
    void drop_oldest() {
        volume_.drop_front(window_.brick_layers);
        first_of_bricks_.pop_front();
    }

    /// A stream's numbers skip the frames that never came. A brick that ends in such a gap gets no picture. Of a gap
    /// longer than the window only the end is shown.
    void fill_gap(const Field& next) {
        const std::int64_t gap = next.index - last_->index - 1;
        const std::int64_t shown = std::min(gap, window_.frames());
        const double length = (next.pts - last_->pts) / static_cast<double>(gap + 1);
        for (std::int64_t i = shown; i > 0; --i) {
            if (volume_.frames() == window_.frames()) drop_oldest();
            volume_.add_missing(next.index - i, next.pts - static_cast<double>(i) * length);
            if (frames_of_newest_ == 0)
                first_of_bricks_.push_back(std::make_shared<const Frame>(Frame{next.index - i, next.pts, {}, {}}));
            if (++frames_of_newest_ == window_.brick_frames()) complete_newest(Draw::no);
        }
    }

    enum class Draw { no, yes };

    void complete_newest(Draw wanted) {
        report_.stages.end("fields");
        update_report();
        if (wanted == Draw::yes) thread_.run([this](Drawing& drawing) { draw(drawing); });
        ++newest_;
        frames_of_newest_ = 0;
    }

    void update_report() {
        const Frame& first = *first_of_bricks_.front();
        report_.frames = volume_.frames() - volume_.missing();
        report_.first_frame = first.index;
        report_.first_pts = first.pts;
        report_.last_pts = last_->pts;
        report_.last_frame = last_->index;
        report_.layers = volume_.layers();
        report_.bricks = cut_by(volume_.layers(), window_.brick_layers);
        report_.still = nothing_visible(volume_, transfer_);
        all_still_ = all_still_ && report_.still;
    }

    /// Pieces of bricks are numbered from the clip's first on, so only what is new is uploaded.
    void show_pieces(BrickWindow& window) const {
        const std::int64_t oldest = newest_ - std::ssize(report_.bricks) + 1;
        window.show(volume_, cut_into_pieces(report_.bricks), oldest * pieces_of_brick_);
    }

    void draw(Drawing& drawing) {
        if (job_.show.contains("volume")) show_pieces(*drawing.window);
        report_.stages.end("draw");
        const bool shows_frames = job_.show.contains("frames");
        Scene scene = build_scene(job_, volume_, {*first_of_bricks_.front(), *last_}, *drawing.layout, drawing.framing);
        report_.arrows = scene.arrows.size();
        ++report_.pictures;
        report_.stages.end("scene");
        report_.frames_missing = report_.frames_missing || (shows_frames && scene.frames.size() < 2);
        add_overlays(job_, drawing, report_.bricks, window_.layers(), scene);
        drawing.renderer->set_scene(std::move(scene));
        report_.lettering = letter(job_, report_, volume_, *drawing.layout, drawing.framing);
        Picture picture = draw_picture(job_, drawing, volume_, report_.lettering);
        report_.stages.end("draw");
        sink_(report_, static_cast<int>(newest_), std::move(picture));
        report_.stages.end("write");
    }

    const RenderJob& job_;
    SlidingWindow window_;
    Volume volume_;
    RenderThread& thread_;
    std::int64_t pieces_of_brick_;  ///< fewer of the clip's last one, if it is shorter
    TransferFunction transfer_;
    const PictureSink& sink_;
    RenderReport report_;
    std::optional<EventFinder> events_;
    std::optional<Moment> begin_;              ///< of the clip
    bool all_still_ = true;                    ///< nothing was visible in any window
    std::deque<SharedFrame> first_of_bricks_;  ///< of the bricks in the window
    SharedFrame last_;
    std::int64_t newest_ = 0;  ///< number of the brick that is being filled
    std::int64_t frames_of_newest_ = 0;
};

}  // namespace

SlidingWindow sliding_window(const RenderJob& job, const FieldSource& source) {
    SlidingWindow window;
    window.bricks = job.bricks;
    const double brick = std::max(1.0, std::round(frames_of_brick(job, source)));
    const auto frames = static_cast<std::int64_t>(brick) * job.bricks;
    window.step = planned_step(job, frames);
    while (frames > job.max_layers * window.step) window.step *= 2;
    const double layers = std::round(brick / static_cast<double>(window.step));
    window.brick_layers = std::max<std::int64_t>(1, static_cast<std::int64_t>(layers));
    return window;
}

RenderReport render_series(const RenderJob& job, FieldSource& source, const FrameProgress& progress,
                           const PictureSink& sink) {
    RenderReport begun;
    RenderThread thread;
    thread.run([&](Drawing& drawing) {
        open_context(job, drawing);
        describe(source, *drawing.context, begun);
        make_renderer(job, source.field_size(), RenderOptions{}.tile_samples, drawing);
    });
    Series series(job, source, thread, std::move(begun), sink);
    const FieldNeeds needs = needs_of(job, source, sliding_window(job, source).frames());
    std::int64_t frames = 0;
    const FieldSummary summary = source.read(needs, [&](const SharedFrame& frame, const Field& field) {
        series.add(frame, field);
        if (progress) progress(++frames);
    });
    RenderReport report = series.finish();
    report.frames = summary.frames;
    report.damaged = summary.damaged;
    return report;
}

}  // namespace vvr
