#include "cli/jobs/render_series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/jobs/build_scene.h"
#include "core/error.h"
#include "core/events/event_finder.h"
#include "gl/context_loan.h"

namespace vvr {

namespace {

constexpr double standard_seconds = 10;
constexpr double standard_frames = 100;  // where nobody knows how many are a second

double frames_of_brick(const RenderJob& job, const FieldSource& source) {
    const VideoInfo& info = source.info();
    if (job.brick_frames > 0) return static_cast<double>(job.brick_frames);
    if (job.brick_seconds > 0) {
        if (info.rate > 0) return job.brick_seconds * info.rate;
        throw Error(ErrorKind::usage,
                    fmt::format("--brick {}s: '{}' does not tell how many frames it has a second; give "
                                "the length of a brick in frames, --brick {:.0f}",
                                job.brick_seconds, info.name, standard_frames));
    }
    const double standard = info.rate > 0 ? standard_seconds * info.rate : standard_frames;
    const auto expected = static_cast<double>(source.expected_frames());
    return expected > 0 ? std::min(standard, std::ceil(expected / job.bricks)) : standard;
}

/// The window while it slides: its volume, its textures, and what is drawn of it.
class Series {
  public:
    Series(const RenderJob& job, const FieldSource& source, Context& context, RenderReport begun,
           const PictureSink& sink)
        : job_(job),
          window_(sliding_window(job, source)),
          volume_(source.field_size(), std::max<std::int64_t>(2, window_.layers()), window_.step,
                  needs_of(job, source, window_.frames()).every),
          layout_(layout_of(job, source.field_size())),
          framing_(frame_volume(job, *layout_)),
          context_(context),
          pieces_of_brick_(std::ssize(cut_into_pieces(std::array{Brick{0, window_.brick_layers}}))),
          renderer_(context, *layout_,
                    options_of(job, framing_, window_.bricks * static_cast<int>(pieces_of_brick_), window_.layers())),
          transfer_(job.transfer.scaled(job.opacity)),
          sink_(sink),
          report_(std::move(begun)) {
        volume_.set_span(window_.layers());
        if (job.show.contains("tracelines")) volume_.keep_flow();
        renderer_.set_transfer(transfer_);
        if (job.find_events) events_.emplace(source.field_size());
        report_.step = window_.step;
        report_.pictures = 0;
    }

    void add(const SharedFrame& frame, const Field& field) {
        if (begin_) fill_gap(field);
        if (!begin_) begin_ = {field.index, field.pts};
        if (volume_.frames() == window_.frames()) drop_oldest();
        if (events_) events_->add({field.scalar, frame->grey, frame->colour}, {field.index, field.pts});
        volume_.add(field, volume_colour(job_, *frame));
        if (frames_of_newest_ == 0) first_of_bricks_.push_back(frame);
        last_ = frame;
        if (++frames_of_newest_ == window_.brick_frames()) complete_newest(Draw::yes);
    }

    /// After the last frame: the last brick may be shorter than the others. Frames and times are those of the clip, all
    /// else is that of the last window.
    /// \param scene the empty scene; may be empty
    RenderReport finish(const Planes& scene) {
        if (frames_of_newest_ > 0) complete_newest(Draw::yes);
        report_.stages.end("fields");
        report_.still = all_still_;
        if (events_) report_.events = choose_events(events_->finish(scene), job_.events);
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

    /// A stream's numbers skip the frames that never came. There is no picture of a brick that ends without one, and
    /// of a gap longer than the window only its end is to be seen.
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
        const BorrowedContext context(context_);
        update_report();
        if (job_.show.contains("volume")) update_ring();
        report_.stages.end("draw");
        if (wanted == Draw::yes) draw();
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

    /// Only the newest brick is uploaded, and single layers of the two that have got another neighbour, or none.
    void update_ring() {
        const std::int64_t oldest = newest_ - std::ssize(report_.bricks) + 1;
        const std::int64_t first = oldest * pieces_of_brick_;
        const std::int64_t of_newest = newest_ * pieces_of_brick_;
        const std::vector<Brick> pieces = cut_into_pieces(report_.bricks);
        const auto layers = [&](std::int64_t number) {
            return BrickLayers(volume_, pieces[static_cast<std::size_t>(number - first)]);
        };
        renderer_.drop_before(first);
        for (std::int64_t i = of_newest; i < first + std::ssize(pieces); ++i) renderer_.push_brick(i, layers(i));
        if (of_newest == first) return;
        renderer_.renew_ends(of_newest - 1, layers(of_newest - 1));
        if (oldest > 0 && first < of_newest - 1) renderer_.renew_ends(first, layers(first));
    }

    void draw() {
        const bool shows_frames = job_.show.contains("frames");
        Scene scene = build_scene(job_, volume_, {*first_of_bricks_.front(), *last_}, *layout_, framing_);
        report_.arrows = scene.arrows.size();
        ++report_.pictures;
        report_.stages.end("scene");
        report_.frames_missing = report_.frames_missing || (shows_frames && scene.frames.size() < 2);
        add_overlays(job_, renderer_, report_.bricks, window_.layers(), *layout_, transfer_, scene);
        renderer_.set_scene(std::move(scene));
        report_.lettering = letter(job_, report_, volume_, *layout_, framing_);
        Picture picture = draw_picture(job_, renderer_, volume_, report_.lettering);
        report_.stages.end("draw");
        sink_(report_, static_cast<int>(newest_), std::move(picture));
        report_.stages.end("write");
    }

    const RenderJob& job_;
    SlidingWindow window_;
    Volume volume_;
    std::unique_ptr<Layout> layout_;
    Framing framing_;
    Context& context_;
    std::int64_t pieces_of_brick_;  ///< fewer of the clip's last one, if it is shorter
    Renderer renderer_;
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
    const auto context = open_drawing(job);
    describe(source, *context, begun);
    Series series(job, source, *context, std::move(begun), sink);
    const FieldNeeds needs = needs_of(job, source, sliding_window(job, source).frames());
    // Fields come from other threads in turn, which draw when a brick is full.
    const ContextForOthers loan(*context);
    std::int64_t frames = 0;
    const FieldSummary summary = source.read(needs, [&](const SharedFrame& frame, const Field& field) {
        series.add(frame, field);
        if (progress) progress(++frames);
    });
    RenderReport report = series.finish(summary.reference);
    report.frames = summary.frames;
    report.damaged = summary.damaged;
    return report;
}

}  // namespace vvr
