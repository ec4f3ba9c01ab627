#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/fields/flow.h"

namespace vvr::fields {

/// What a solver of Horn and Schunck's equations is told.
struct SolverSettings {
    double alpha = 0;
    int iterations = 0;
    double pre_smooth = 0;  ///< σ in pixels and frames
    bool cube = false;      ///< derivatives of the cube of 2×2×2 values in place of Barron's
};

/// One row of the solver table, with its defaults.
struct SolverRow {
    std::string_view name;
    std::string_view help;
    SolverSettings defaults;
    std::unique_ptr<FlowMethod> (*make)(const SolverSettings& settings);
};

std::span<const SolverRow> flow_solvers();

/// The paper's: Jacobi steps from zero.
std::unique_ptr<FlowMethod> make_jacobi(const SolverSettings& settings);

/// The same equations solved to the truth by full multigrid, `iterations` cycles a grid.
std::unique_ptr<FlowMethod> make_multigrid(const SolverSettings& settings);

/// Coarse to fine: at each scale `iterations` times the second frame is warped by the flow so far and the equations
/// solved again, after Meinhardt-Llopis, Sánchez and Kondermann (Image Processing On Line, 2013). Follows motion of
/// many pixels per frame.
std::unique_ptr<FlowMethod> make_pyramid(const SolverSettings& settings);

}  // namespace vvr::fields
