#include "core/fields/pipeline.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>
#include <opencv2/core/utility.hpp>

#include "core/base/error.h"
#include "core/base/words.h"
#include "core/fields/clip_reader.h"
#include "core/fields/field_stages.h"
#include "core/fields/region.h"
#include "core/fields/settings.h"

namespace vvr::fields {
namespace {

using oneapi::tbb::filter_mode;
using oneapi::tbb::make_filter;

/// Keeps OpenCV from starting threads of its own within ours: frames are what is shared out here, and its dense
/// inverse search gives other results for another number of threads.
class SingleThreadedOpenCv {
  public:
    SingleThreadedOpenCv() : before_(cv::getNumThreads()) { cv::setNumThreads(1); }
    ~SingleThreadedOpenCv() { cv::setNumThreads(before_); }
    SingleThreadedOpenCv(const SingleThreadedOpenCv&) = delete;
    SingleThreadedOpenCv& operator=(const SingleThreadedOpenCv&) = delete;

  private:
    int before_;
};

/// Where the first error of a pipeline is kept. oneTBB loses the item of a filter that throws, and so its memory: the
/// filters hand their errors to this instead, and the pipeline ends in good order.
class FirstError {
  public:
    /// What `work` returns; an empty result if it throws, or if something has failed before.
    template <class Work>
    auto guard(const Work& work) -> decltype(work()) {
        using Made = decltype(work());
        if (!context_.is_group_execution_cancelled()) {
            try {
                return work();
            } catch (...) {
                const std::scoped_lock lock(mutex_);
                if (!error_) error_ = std::current_exception();
                context_.cancel_group_execution();
            }
        }
        return Made();
    }

    void rethrow() const {
        if (error_) std::rethrow_exception(error_);
    }

    oneapi::tbb::task_group_context& context() { return context_; }

  private:
    oneapi::tbb::task_group_context context_;
    std::mutex mutex_;
    std::exception_ptr error_;
};

struct Result {
    video::SharedFrame frame;
    Field field;
};

int threads_of(const FieldOptions& options) {
    const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    return options.threads > 0 ? options.threads : cores;
}

/// Runs `work` with this many threads. oneTBB would warn on stderr if they are more than the cores, which is the
/// caller's choice.
template <class Work>
void on_threads(int threads, const Work& work) {
    using oneapi::tbb::global_control;
    const std::size_t allowed = global_control::active_value(global_control::max_allowed_parallelism);
    const global_control control(global_control::max_allowed_parallelism,
                                 std::max(static_cast<std::size_t>(threads), allowed));
    oneapi::tbb::task_arena(threads).execute(work);
}

std::int64_t run(const FrameReader& read, FieldStages& work, const FieldOptions& options, const FieldSink& sink) {
    int turns_left = work.reach();  // empty ones after the last frame, so that the last ones get their neighbours
    bool ended = false;
    std::int64_t frames = 0;
    const auto is_wanted = [&](const video::Frame& frame) {
        return !video::is_before(options.span, frame.index, frame.pts) &&
               !video::is_past(options.span, frame.index, frame.pts) &&
               !video::is_between_parts(options.span, frame.pts);
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
    const auto begin = make_filter<FrameJob, std::shared_ptr<PipelineFrame>>(filter_mode::parallel, [&](const FrameJob& job) {
        return first.guard([&] { return job ? work.begin(job()) : std::shared_ptr<PipelineFrame>{}; });
    });
    const auto gather = make_filter<std::shared_ptr<PipelineFrame>, Neighbourhood>(
        filter_mode::serial_in_order,
        [&](std::shared_ptr<PipelineFrame> shot) { return first.guard([&] { return work.gather(std::move(shot)); }); });
    const auto result_of = [&](const Neighbourhood& about) -> std::shared_ptr<Result> {
        if (about.empty()) return nullptr;  // something has failed
        const PipelineFrame* const here = about[static_cast<std::size_t>(work.reach())].get();
        if (here == nullptr || !is_wanted(*here->frame)) return nullptr;
        return std::make_shared<Result>(Result{here->frame, work.finish(about)});
    };
    const auto finish = make_filter<Neighbourhood, std::shared_ptr<Result>>(
        filter_mode::parallel,
        [&](const Neighbourhood& about) { return first.guard([&] { return result_of(about); }); });
    const auto hand_over = [&](const std::shared_ptr<Result>& result) {
        if (!result) return;
        ++frames;
        sink(result->frame, std::move(result->field));
    };
    const auto deliver = make_filter<std::shared_ptr<Result>, void>(
        filter_mode::serial_in_order,
        [&](const std::shared_ptr<Result>& result) { first.guard([&] { hand_over(result); }); });
    const int threads = threads_of(options);
    // Twice the threads keeps them all busy while one waits for its turn in a stage that is in order.
    on_threads(threads, [&] {
        oneapi::tbb::parallel_pipeline(static_cast<std::size_t>(2 * threads),
                                       source & begin & gather & finish & deliver, first.context());
    });
    first.rethrow();
    return frames;
}

}  // namespace

std::int64_t compute_fields(const FrameReader& read, const EmptyScene& scene, const FieldOptions& options,
                            const FieldSink& sink) {
    validate(options);
    const SingleThreadedOpenCv one_thread;
    FieldStages work(scene, options);
    return run(read, work, options, sink);
}

FieldSummary compute_fields(video::FrameSource& source, const FieldOptions& options, const FieldSink& sink) {
    validate(options);
    EmptyScene scene{.reference = {},
                     .region = make_region(options, source.field_size(), source.info().size),
                     .frames = source.info().frames};
    const SingleThreadedOpenCv one_thread;
    if (needs_reference(options)) {
        on_threads(threads_of(options), [&] { scene.reference = make_reference(source, options); });
    }
    FieldStages work(scene, options);
    ClipReader read(source, options.span, work.reach(), work.is_stateful());
    FieldSummary summary;
    summary.frames = run([&] { return read(); }, work, options, sink);
    summary.damaged = source.damaged();
    summary.problems = source.problems();
    summary.reference = std::move(scene.reference);
    // A stream may end with nothing but the frames that the reference took.
    if (summary.frames == 0 && options.span != video::FrameSpan{}) {
        throw Error(ErrorKind::usage,
                    fmt::format("'{}' has no frame {}: it has {}, the last at {:.3f} s; change the start or the end",
                                source.info().name, video::text_of(options.span),
                                counted(read.last_index() + 1, "frame"), read.last_pts()),
                    {setting::start.name, setting::end.name});
    }
    return summary;
}

}  // namespace vvr::fields
