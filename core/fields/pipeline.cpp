#include "core/fields/pipeline.h"

#include <algorithm>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include "core/error.h"
#include "core/fields/filter.h"
#include "core/fields/flow.h"
#include "core/fields/seeds.h"

namespace vvr {
namespace {

using oneapi::tbb::filter_mode;
using oneapi::tbb::make_filter;

/// A frame on its way through the pipeline. Its neighbours look at it too, so nothing is moved out of it.
struct Shot {
    Frame frame;
    Plane<std::uint8_t> object;  ///< the difference object, where seeds need it
    FlowFrame flow_frame;
    std::once_flag prepared;
};
using ShotPtr = std::shared_ptr<Shot>;

/// A frame with those about it: `shots[before]` is the frame, the others are null past the clip's ends.
struct Neighbourhood {
    std::vector<ShotPtr> shots;
};

struct Result {
    Frame frame;
    Field field;
};

/// What all frames share.
class Work {
  public:
    Work(const Reference& reference, const FieldOptions& options)
        : options_(options), row_(find_filter(options.filter)), filter_(row_.make(options, reference)) {
        flow_ = make_flow(options.flow);
        reach_ = flow_ ? flow_->reach() : row_.needs.previous ? 1 : 0;
    }

    int reach() const { return reach_; }

    Result operator()(const Neighbourhood& about) const {
        Shot& here = *about.shots[static_cast<std::size_t>(reach_)];
        Result result{here.frame, {}};
        Field& field = result.field;
        field.index = here.frame.index;
        field.pts = here.frame.pts;
        if (flow_ && here.frame.index % options_.flow.every == 0) field.flow = flow(about);
        const Shot* before = reach_ > 0 ? about.shots[static_cast<std::size_t>(reach_) - 1].get() : nullptr;
        field.scalar = (*filter_)({here.frame, before ? &before->frame : nullptr, &field.flow});
        if (!field.flow.u.empty()) field.seeds = make_seeds(field.flow, field.scalar, options_.seeds);
        return result;
    }

  private:
    // Past an end of the clip the end's frame stands again.
    Flow flow(const Neighbourhood& about) const {
        const int count = static_cast<int>(about.shots.size());
        std::vector<const FlowFrame*> frames(about.shots.size());
        for (int step : {-1, 1}) {
            Shot* nearest = nullptr;
            for (int k = reach_; k >= 0 && k < count; k += step) {
                if (about.shots[static_cast<std::size_t>(k)]) nearest = about.shots[static_cast<std::size_t>(k)].get();
                frames[static_cast<std::size_t>(k)] = &prepared(*nearest);
            }
        }
        return (*flow_)(frames);
    }

    // The first neighbour that asks does it; frames that no flow looks at cost nothing.
    const FlowFrame& prepared(Shot& shot) const {
        std::call_once(shot.prepared, [&] { shot.flow_frame = {shot.frame.grey, flow_->prepare(shot.frame.grey)}; });
        return shot.flow_frame;
    }

    FieldOptions options_;
    const FilterRow& row_;
    std::unique_ptr<Filter> filter_;
    std::unique_ptr<FlowMethod> flow_;
    int reach_ = 0;
};

/// Holds back the last frames until their neighbours have come.
class Window {
  public:
    explicit Window(int reach) : shots_(static_cast<std::size_t>(2 * reach + 1)) {}

    /// Takes the next frame, or null after the last one; the neighbourhood of the frame `reach` steps before it.
    Neighbourhood push(ShotPtr shot) {
        shots_.pop_front();
        shots_.push_back(std::move(shot));
        return {{shots_.begin(), shots_.end()}};
    }

  private:
    std::deque<ShotPtr> shots_;
};

}  // namespace

std::int64_t compute_fields(const FrameReader& read, const Reference& reference, const FieldOptions& options,
                            const FieldSink& sink) {
    const Work work(reference, options);
    const int threads = options.threads > 0 ? options.threads : static_cast<int>(std::thread::hardware_concurrency());
    Window window(work.reach());
    int still_to_come = work.reach();  // empty turns after the last frame, to push the last ones out of the window
    bool ended = false;
    std::int64_t frames = 0;

    const auto source =
        make_filter<void, FrameJob>(filter_mode::serial_in_order, [&](oneapi::tbb::flow_control& control) -> FrameJob {
            if (!ended) {
                if (FrameJob job = read()) return job;
                ended = true;
            }
            if (still_to_come-- == 0) control.stop();
            return {};
        });
    const auto make_frame = make_filter<FrameJob, ShotPtr>(filter_mode::parallel, [](const FrameJob& job) {
        if (!job) return ShotPtr{};
        auto shot = std::make_shared<Shot>();
        shot->frame = job();
        return shot;
    });
    const auto gather = make_filter<ShotPtr, Neighbourhood>(filter_mode::serial_in_order,
                                                            [&](ShotPtr shot) { return window.push(std::move(shot)); });
    const auto compute = make_filter<Neighbourhood, std::shared_ptr<Result>>(
        filter_mode::parallel, [&](const Neighbourhood& about) -> std::shared_ptr<Result> {
            if (!about.shots[static_cast<std::size_t>(work.reach())]) return nullptr;
            return std::make_shared<Result>(work(about));
        });
    const auto deliver = make_filter<std::shared_ptr<Result>, void>(
        filter_mode::serial_in_order, [&](const std::shared_ptr<Result>& result) {
            if (!result) return;
            ++frames;
            sink(std::move(result->frame), std::move(result->field));
        });

    // Twice the threads keeps them all busy while one waits for its turn in a stage that is in order.
    // More threads than cores is the caller's choice; oneTBB would grumble about it on stderr.
    const auto workers =
        std::max(static_cast<std::size_t>(threads),
                 oneapi::tbb::global_control::active_value(oneapi::tbb::global_control::max_allowed_parallelism));
    const oneapi::tbb::global_control allowed(oneapi::tbb::global_control::max_allowed_parallelism, workers);
    oneapi::tbb::task_arena(threads).execute([&] {
        oneapi::tbb::parallel_pipeline(static_cast<std::size_t>(2 * threads),
                                       source & make_frame & gather & compute & deliver);
    });
    return frames;
}

}  // namespace vvr
