#include "core/fields/field_source.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>

#include <fmt/format.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fields/delivery.h"
#include "core/fields/field_stages.h"
#include "core/fields/filter.h"
#include "core/fields/flow.h"
#include "core/fields/opencv_threads.h"
#include "core/fields/region.h"
#include "core/fields/settings.h"
#include "core/media/decoder.h"
#include "core/media/frame_span.h"
#include "core/media/scaler.h"

namespace vvr::fields {

/// Reads the frames of a span with `context` frames on each side. Must outlive the jobs that it returns.
class ClipReader {
  public:
    /// \param source at its first frame
    /// \param from_first whether all frames before the span are needed too
    ClipReader(media::FrameSource& source, const FieldOptions& options, int context, bool from_first);

    /// The next frame's job; an empty function at the end.
    FrameJob operator()();

    /// The number of the last frame read; -1 = none so far.
    std::int64_t last_index() const { return last_index_; }
    double last_pts() const { return last_pts_; }

    /// Damage in the span, and next to it.
    std::vector<media::Damage>& damage() { return damage_; }

    /// Whether the clip has no further frame.
    bool has_ended() const { return has_ended_; }

  private:
    std::shared_ptr<media::DecodedFrame> read();
    void seek_to_span();
    void collect_context();

    media::FrameSource& source_;
    media::FrameSpan span_;
    std::size_t context_;
    bool begun_ = false;
    bool from_first_;
    bool full_size_;
    std::size_t past_end_ = 0;
    std::int64_t last_index_ = -1;
    double last_pts_ = 0;
    std::int64_t damaged_ = 0;  ///< packets so far
    std::vector<media::Damage> damage_;
    bool is_damaged_ = false;
    bool has_ended_ = false;
    std::deque<std::shared_ptr<media::DecodedFrame>> waiting_;
    oneapi::tbb::enumerable_thread_specific<media::Scaler> scalers_;
};

ClipReader::ClipReader(media::FrameSource& source, const FieldOptions& options, int context, bool from_first)
    : source_(source),
      span_(options.span),
      context_(static_cast<std::size_t>(context)),
      from_first_(from_first),
      full_size_(options.full_size),
      scalers_([&source] { return media::Scaler(source); }) {}

std::shared_ptr<media::DecodedFrame> ClipReader::read() {
    const double before = last_pts_;
    std::shared_ptr<media::DecodedFrame> frame = source_.next();
    if (frame) {
        last_index_ = frame->index;
        last_pts_ = frame->pts;
    }
    const std::int64_t damaged = source_.damaged();
    const std::int64_t more = damaged - std::exchange(damaged_, damaged);
    const bool is_wanted = !media::is_before(span_, last_index_, last_pts_) &&
                           !media::is_past(span_, last_index_, before) && !media::is_between_parts(span_, last_pts_);
    if (more > 0 && is_wanted) add_damage(damage_, {before, last_pts_, more});
    if (more > 0) {
        is_damaged_ = true;
    } else if (frame && media::is_key_frame(*frame->image)) {
        is_damaged_ = false;
    }
    has_ended_ = frame == nullptr;
    return frame;
}

/// Reads up to the first frame of the span and keeps the last few before it, unscaled.
void ClipReader::collect_context() {
    waiting_.clear();
    while (auto frame = read()) {
        const bool counts = !media::is_before(span_, frame->index, frame->pts);
        waiting_.push_back(std::move(frame));
        if (counts) return;
        if (waiting_.size() > context_) waiting_.pop_front();
    }
    waiting_.clear();
}

void ClipReader::seek_to_span() {
    if (from_first_ || span_ == media::FrameSpan{}) return;
    const double rate = source_.info().rate;
    if (rate > 0) {
        const double start = std::max(span_.start, static_cast<double>(span_.first) / rate);
        source_.seek(start - (static_cast<double>(context_) + 2) / rate);
    }
    collect_context();
    const bool whole = waiting_.size() > context_ || (!waiting_.empty() && waiting_.front()->index == 0);
    if (rate <= 0 || whole) return;
    // With a variable frame rate, the estimated position may be too late.
    source_.rewind();
    damage_.clear();
    collect_context();
}

FrameJob ClipReader::operator()() {
    if (!std::exchange(begun_, true)) seek_to_span();
    std::shared_ptr<media::DecodedFrame> decoded;
    if (waiting_.empty()) {
        decoded = read();
    } else {
        decoded = std::move(waiting_.front());
        waiting_.pop_front();
    }
    if (!decoded) return {};
    if (media::is_past(span_, decoded->index, decoded->pts) && past_end_++ == context_) return {};
    return [this, decoded, damaged = is_damaged_]() -> ReadFrame {
        media::Frame frame = scalers_.local()(*decoded);
        frame.damaged = damaged;
        if (!full_size_) return {std::move(frame)};
        frame.full_size.picture = decoded;
        return {std::move(frame), decoded};
    };
}

namespace {

void validate(const media::FrameSpan& span) {
    // Written this way, the condition also refuses NaN.
    if (!(span.start >= 0) || span.first < 0) {
        throw Error(ErrorCode::option_value_out_of_range,
                    fmt::format("start: {} is negative; the clip begins at 0",
                                span.first < 0 ? static_cast<double>(span.first) : span.start),
                    {setting::start.name});
    }
    if ((span.end && *span.end <= span.start) || (span.stop && *span.stop <= span.first)) {
        throw Error(ErrorCode::span_empty,
                    fmt::format("end: the clip {} is empty; give an end after the start", media::text_of(span)),
                    {setting::end.name});
    }
}

}  // namespace

void validate(const FieldOptions& options) {
    each_field_setting(options,
                       [](const Setting& setting, const auto& value, const auto&...) { check(setting, value); });
    check(setting::flow_every, options.flow.every);
    check(setting::threads, options.threads);
    validate(options.span);
    const bool draws_given = options.filter->traits.given;
    if (draws_given && options.given_folder.empty()) {
        throw Error(
            ErrorCode::option_needs_another,
            fmt::format("filter {} needs the folder of the fields; name it with --field DIR", options.filter->name),
            {setting::filter.name, setting::field.name});
    }
    if (!draws_given && !options.given_folder.empty()) {
        throw Error(ErrorCode::options_conflict,
                    fmt::format("field {}: it replaces the filter, but the filter {} is given too; drop one of the two",
                                options.given_folder, options.filter->name),
                    {setting::field.name, setting::filter.name});
    }
    // Also where a picture shows no flow: a wrong name must not go unnoticed.
    if (draws_given) open_field_files(options.given_folder);
    if (options.flow.method.is_folder()) open_flow_files(options.flow.method.name());
    validate_region(setting::roi.name, options.roi);
    validate_region(setting::mask.name, options.mask);
}

namespace {

using oneapi::tbb::filter_mode;
using oneapi::tbb::make_filter;

// Frames already run in parallel, and OpenCV's dense inverse search gives other results for another number of threads.
constexpr int single_thread = 1;

/// Keeps the first error of a pipeline. oneTBB leaks the item of a filter that throws, and the items in flight where a
/// pipeline is cancelled; so filters report errors here, make empty items from then on, and the pipeline ends normally.
class FirstError {
  public:
    /// The result of `work`; an empty one if it throws, or if something has failed before.
    template <class Work>
    auto guard(const Work& work) -> decltype(work()) {
        using Made = decltype(work());
        if (!failed_) {
            try {
                return work();
            } catch (...) {
                const std::scoped_lock lock(mutex_);
                if (!error_) error_ = std::current_exception();
                failed_ = true;
            }
        }
        return Made();
    }

    void rethrow() const {
        if (error_) std::rethrow_exception(error_);
    }

  private:
    std::atomic<bool> failed_ = false;
    std::mutex mutex_;
    std::exception_ptr error_;
};

int threads_of(const FieldOptions& options) {
    const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    return options.threads > 0 ? options.threads : cores;
}

/// Runs `work` on this many threads. Suppresses oneTBB's warning on stderr where these are more than the cores: the
/// caller chose them.
template <class Work>
void on_threads(int threads, const Work& work) {
    using oneapi::tbb::global_control;
    const std::size_t allowed = global_control::active_value(global_control::max_allowed_parallelism);
    const global_control control(global_control::max_allowed_parallelism,
                                 std::max(static_cast<std::size_t>(threads), allowed));
    oneapi::tbb::task_arena(threads).execute(work);
}

/// The number of frames in the pipeline at a time: twice as many as threads, so that all threads stay busy while frames
/// wait for a serial stage. Where frames keep their decoded pictures, these have a limit of memory.
std::size_t frames_at_a_time(const FieldOptions& options, std::int64_t pixels) {
    constexpr std::int64_t pixels_in_flight = 128'000'000;
    constexpr std::int64_t fewest = 4;
    const std::int64_t busy = 2 * threads_of(options);
    if (!options.full_size || pixels <= 0) return static_cast<std::size_t>(busy);
    return static_cast<std::size_t>(std::min(busy, std::max(fewest, pixels_in_flight / pixels)));
}

/// \param pixels of a decoded picture; 0 = there are none
std::int64_t run(const FrameReader& read, FieldStages& work, const FieldOptions& options, std::int64_t pixels,
                 const FieldSink& sink) {
    int turns_left = work.reach();  // empty turns after the last frame, which give the last frames their neighbours
    bool ended = false;
    FieldDelivery deliver_field(sink);
    const auto is_wanted = [&](const media::Frame& frame) {
        return !media::is_before(options.span, frame.index, frame.pts) &&
               !media::is_past(options.span, frame.index, frame.pts) &&
               !media::is_between_parts(options.span, frame.pts);
    };

    FirstError first;
    const auto source =
        make_filter<void, FrameJob>(filter_mode::serial_in_order, [&](oneapi::tbb::flow_control& control) -> FrameJob {
            if (!ended) {
                if (FrameJob job = first.guard(read)) return job;
                ended = true;
            }
            if (turns_left-- == 0) control.stop();
            return {};
        });
    const auto begun = [&](ReadFrame&& read_frame) {
        auto shot = work.begin(std::move(read_frame.frame));
        shot->decoded = std::move(read_frame.decoded);
        return shot;
    };
    const auto begin =
        make_filter<FrameJob, std::shared_ptr<PipelineFrame>>(filter_mode::parallel, [&](const FrameJob& job) {
            return first.guard([&] { return job ? begun(job()) : std::shared_ptr<PipelineFrame>{}; });
        });
    const auto gather = make_filter<std::shared_ptr<PipelineFrame>, Neighbourhood>(
        filter_mode::serial_in_order,
        [&](std::shared_ptr<PipelineFrame> shot) { return first.guard([&] { return work.gather(std::move(shot)); }); });
    const auto result_of = [&](const Neighbourhood& neighbours) -> std::shared_ptr<PipelineResult> {
        if (neighbours.empty()) return nullptr;  // something has failed
        PipelineFrame* const here = neighbours[static_cast<std::size_t>(work.reach())].get();
        if (here == nullptr) return nullptr;
        // Its later neighbours keep the frame, but not the picture.
        std::shared_ptr<const media::DecodedFrame> decoded = std::move(here->decoded);
        if (!is_wanted(*here->frame)) return nullptr;
        return std::make_shared<PipelineResult>(
            PipelineResult{here->frame, work.finish(neighbours), here->verdict, std::move(decoded)});
    };
    const auto finish = make_filter<Neighbourhood, std::shared_ptr<PipelineResult>>(
        filter_mode::parallel,
        [&](const Neighbourhood& neighbours) { return first.guard([&] { return result_of(neighbours); }); });
    const auto deliver = make_filter<std::shared_ptr<PipelineResult>, void>(
        filter_mode::serial_in_order, [&](const std::shared_ptr<PipelineResult>& result) {
            if (result) first.guard([&] { deliver_field(std::move(*result)); });
        });
    on_threads(threads_of(options), [&] {
        oneapi::tbb::parallel_pipeline(frames_at_a_time(options, pixels), source & begin & gather & finish & deliver);
    });
    first.guard([&] { deliver_field.finish(); });
    first.rethrow();
    return deliver_field.frames();
}

/// \param frames of the whole clip
/// \throws Error io if a folder has files for more
void check_no_more_files(const FieldOptions& options, std::int64_t frames) {
    if (!options.given_folder.empty()) open_field_files(options.given_folder).check_end(frames);
    if (options.flow.method.is_folder()) open_flow_files(options.flow.method.name()).check_end(frames);
}

}  // namespace

std::int64_t compute_fields(const FrameReader& read, const EmptyScene& scene, const FieldOptions& options,
                            const FieldSink& sink) {
    validate(options);
    const OpenCvThreads one_thread(single_thread);
    FieldStages work(scene, options);
    return run(read, work, options, 0, sink);
}

FieldSummary compute_fields(media::FrameSource& source, const FieldOptions& options, const FieldSink& sink,
                            const SceneSink& scene_sink, const LivingFinder& find_living) {
    validate(options);
    EmptyScene scene{.reference = {},
                     .region = make_region(options, source.field_size(), source.info().size),
                     .frames = source.info().frames};
    const OpenCvThreads one_thread(single_thread);
    if (needs_reference(options)) {
        on_threads(threads_of(options), [&] { scene.reference = make_reference(source, options, find_living); });
        if (scene_sink) scene_sink(scene.reference);
    }
    FieldStages work(scene, options);
    ClipReader read(source, options, work.reach(), work.is_stateful());
    const Size decoded = source.info().size;
    FieldSummary summary;
    summary.frames = run([&] { return read(); }, work, options, std::int64_t{decoded.width} * decoded.height, sink);
    if (read.has_ended()) check_no_more_files(options, read.last_index() + 1);
    summary.damage = std::move(read.damage());
    for (const media::Damage& damage : summary.damage) summary.damaged += damage.packets;
    summary.problems = source.problems();
    summary.doubtful_times = source.doubtful_times();
    summary.reference = std::move(scene.reference);
    // A stream may end with the frames from which the reference was learnt.
    if (summary.frames == 0 && options.span != media::FrameSpan{}) {
        throw Error(ErrorCode::span_empty,
                    fmt::format("'{}' has no frame {}: it has {}, the last at {:.3f} s; change the start or the end",
                                source.info().name, media::text_of(options.span),
                                counted(read.last_index() + 1, "frame"), read.last_pts()),
                    {setting::start.name, setting::end.name});
    }
    return summary;
}

ClipFields::ClipFields(std::unique_ptr<media::FrameSource> clip, FieldOptions options)
    : clip_(std::move(clip)), options_(std::move(options)) {}

FieldSummary ClipFields::read(const FieldNeeds& needs, const FieldSink& sink) {
    if (std::exchange(begun_, true)) clip_->rewind();
    FieldOptions options = options_;
    options.flow.every = needs.every;
    options.flow.every_frame = needs.flow_of_every_frame;
    options.full_size = needs.full_size;
    const bool shown = options.filter->traits.flow || (options.second != nullptr && options.second->traits.flow);
    if (!needs.seeds && !needs.flow && !needs.flow_of_every_frame && !shown) options.flow.method = FlowChoice::none();
    FieldSummary summary = compute_fields(*clip_, options, sink, needs.scene, needs.find_living);
    shakes_ = summary.reference.shakes;
    return summary;
}

void ClipFields::read_again(std::span<const double> times, const std::function<void(const media::Frame&)>& sink) {
    // How far the camera had moved is not known any more.
    if (shakes_) return;
    media::Scaler scale(*clip_);
    clip_->read_again(times, [&](const std::shared_ptr<media::DecodedFrame>& decoded) {
        media::Frame frame = scale(*decoded);
        frame.pts = *std::ranges::min_element(times, {}, [&](double time) { return std::abs(time - frame.pts); });
        frame.full_size.picture = decoded;
        sink(frame);
    });
}

}  // namespace vvr::fields
