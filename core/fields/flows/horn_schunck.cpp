#include <array>
#include <vector>

#include <oneapi/tbb/enumerable_thread_specific.h>

#include "core/base/setting.h"
#include "core/fields/flow.h"
#include "core/fields/flows/derivatives.h"
#include "core/fields/flows/linear_system.h"
#include "core/fields/thresholds.h"
#include "core/kernels/rows.h"

namespace vvr::fields {
namespace {

Plane<float> along_time(std::span<const Plane<float>* const> frames, std::span<const float> taps) {
    auto result = Plane<float>::for_overwrite(frames.front()->size());
    std::vector<const float*> inputs;
    for (const Plane<float>* frame : frames) inputs.push_back(frame->pixels().data());
    kernels::weighted_sum(inputs, taps, result.pixels().data(), static_cast<int>(result.pixels().size()));
    return result;
}

/// A thread's buffers, which it reuses for each frame.
struct LinearWorkspace {
    PlaneStack derivatives;
    LinearSystem system;
};

/// The paper's solver: Jacobi iterations from zero. The equations are linearized about zero flow, so they are valid up
/// to about two pixels per frame.
class Jacobi final : public FlowMethod {
  public:
    explicit Jacobi(const SolverSettings& settings)
        : alpha2_(static_cast<float>(settings.alpha * settings.alpha)),
          iterations_(settings.iterations),
          cube_(settings.cube),
          taps_(gaussian_taps(settings.cube ? 0 : thresholds.flow.barron_smooth)) {}

    int reach() const override {
        const auto smoothing = static_cast<int>(taps_.size() / 2);
        return cube_ ? smoothing + 1 : smoothing + 2;
    }

    // An iteration uses the neighbours of each point.
    int margin() const override { return iterations_; }

    FlowFrame prepare(const Plane<std::uint8_t>& grey) const override { return {grey, {smoothed(grey, taps_)}}; }

    Flow operator()(std::span<const FlowFrame* const> frames, const PixelBox& part) const override {
        std::vector<const Plane<float>*> planes;
        for (const FlowFrame* frame : frames) planes.push_back(&frame->levels.front());
        LinearWorkspace& work = workspaces_.local();
        if (cube_) {
            cube(planes, part, work.derivatives);
        } else {
            barron_derivatives(planes, taps_, part, work.derivatives);
        }
        work.system.reset(work.derivatives.size(), alpha2_);
        work.system.load(work.derivatives);
        work.system.clear();
        work.system.relax(iterations_);
        return work.system.flow();
    }

  private:
    // From this frame to the next; at the clip's end, from the previous frame to this one.
    void cube(std::span<const Plane<float>* const> planes, const PixelBox& part, PlaneStack& result) const {
        const std::size_t middle = planes.size() / 2;
        const std::size_t first = planes[middle + 1] == planes[middle] ? middle - 1 : middle;
        if (taps_.size() == 1) return cube_derivatives(*planes[first], *planes[first + 1], part, result);
        const std::size_t before = first - taps_.size() / 2;
        cube_derivatives(along_time(planes.subspan(before, taps_.size()), taps_),
                         along_time(planes.subspan(before + 1, taps_.size()), taps_), part, result);
    }

    float alpha2_;
    int iterations_;
    bool cube_;
    std::vector<float> taps_;
    mutable oneapi::tbb::enumerable_thread_specific<LinearWorkspace> workspaces_;
};

constexpr std::array solvers{
    SolverRow{"pyramid",
              "coarse to fine with warping, for motion of many pixels per frame",
              {.alpha = 15, .iterations = 1},
              make_pyramid},
    SolverRow{"jacobi",
              "the paper's: a number of steps from zero",
              {.alpha = 10, .iterations = 60},
              [](const SolverSettings& settings) -> std::unique_ptr<FlowMethod> {
                  return std::make_unique<Jacobi>(settings);
              }},
};

constexpr std::array derivatives{
    DerivativeRow{"barron", "five points along x, y and t (Barron, Fleet and Beauchemin 1994)", false},
    DerivativeRow{"cube", "the cube of 2x2x2 pixels (Horn and Schunck 1981)", true},
};

}  // namespace

std::span<const DerivativeRow> derivative_kinds() {
    return derivatives;
}

std::span<const SolverRow> flow_solvers() {
    return solvers;
}

std::unique_ptr<FlowMethod> make_horn_schunck(const FlowOptions& options) {
    SolverSettings settings = options.solver->defaults;
    if (options.alpha) settings.alpha = *options.alpha;
    if (options.iterations) settings.iterations = *options.iterations;
    settings.cube = options.derivatives->cube;
    return options.solver->make(settings);
}

const DerivativeRow& row_of(Name<DerivativeRow> name) {
    return choose("derivatives", name.text, derivative_kinds());
}

const SolverRow& row_of(Name<SolverRow> name) {
    return choose("solver", name.text, flow_solvers());
}

}  // namespace vvr::fields
