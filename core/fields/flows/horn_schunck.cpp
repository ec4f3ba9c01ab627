#include <array>

#include "core/base/setting.h"
#include "core/fields/flow.h"

namespace vvr::fields {
namespace {

constexpr std::array solvers{
    SolverRow{"pyramid",
              "coarse to fine with warping, for motion of many pixels per frame",
              {.alpha = 15, .iterations = 1, .pre_smooth = 0.8},
              make_pyramid},
    SolverRow{"jacobi",
              "the paper's: a number of steps from zero",
              {.alpha = 10, .iterations = 60, .pre_smooth = 1.5},
              make_jacobi},
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
    if (options.pre_smooth) settings.pre_smooth = *options.pre_smooth;
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
