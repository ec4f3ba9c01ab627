#pragma once

#include "core/base/setting.h"
#include "core/fields/filter.h"
#include "core/fields/flow.h"
#include "core/fields/illumination.h"
#include "core/fields/planes.h"
#include "core/fields/reference.h"
#include "core/fields/seeds.h"
#include "core/fields/shadows.h"
#include "core/fields/stabilizer.h"
#include "core/media/settings.h"

/// The settings of FieldOptions.
namespace vvr::setting {

inline constexpr Setting filter{"filter", "NAME", "what the scalar field shows"};
inline constexpr Setting field{
    .name = "field",
    .unit = "DIR",
    .help =
        "draw your own scalar fields instead of a filter's: a folder with a grey picture (.png, .exr, .tif) for each "
        "frame, whose name ends in the frame's number, from 0",
    .may_be_file = true,
    .not_live_reason = "a stream's frames have no pictures yet"};
inline constexpr Setting reference{
    .name = "reference", .unit = "NAME", .help = "source of the empty scene", .may_be_file = true};
inline constexpr Setting threshold{
    "threshold", "GREY", "smallest difference that counts; the default depends on --filter", {0, 255}, "the filter's"};
inline constexpr Setting norm{"norm", "NAME", "distance between two colours"};
inline constexpr Setting smooth{
    "smooth", "PIXELS", "standard deviation of the Gaussian smoothing before a comparison; 0 = none", {0, 20}};
inline constexpr Setting min_area{"min-area", "PIXELS", "remove blobs of fewer field pixels", {0, 1'000'000}};
inline constexpr Setting illumination{"illumination", "NAME", "changes of light that are compensated"};
inline constexpr Setting shadows{"shadows", "NAME", "what to do with cast shadows"};
inline constexpr Setting stabilize{"stabilize", "NAME", "what to do when the camera shakes"};
inline constexpr Setting roi{.name = "roi", .unit = "AREA", .help = "use only this area", .may_be_file = true};
inline constexpr Setting mask{
    .name = "mask", .unit = "AREA", .help = "ignore this area, for example a clock in the video", .may_be_file = true};

inline constexpr Setting flow{
    .name = "flow", .unit = "NAME", .help = "method of the optical flow", .may_be_file = true};
inline constexpr Setting flow_every{
    "flow-every", "FRAMES", "keep flow and seeds of frames whose number is a multiple of this", {1, 1e9}};
inline constexpr Setting solver{"solver", "NAME", "solver of the method horn-schunck"};
inline constexpr Setting derivatives{"derivatives", "NAME", "derivatives for the solver jacobi; pyramid has its own"};
/// Below this, float can't represent α² beside the squared derivatives.
inline constexpr Setting alpha{
    "alpha",
    "NUMBER",
    "weight of smoothness in horn-schunck; its square is the paper's λ; the default depends on --solver",
    {0.01, 10'000},
    "the solver's"};
inline constexpr Setting iterations{
    "iterations",
    "COUNT",
    "iterations of the solver: warps per scale (pyramid) or steps (jacobi); the default depends on --solver",
    {1, 100'000},
    "the solver's"};

inline constexpr Setting grid{"grid", "PIXELS", "distance between neighbouring seeds", {1, 10'000}};
inline constexpr Setting min_magnitude{
    "min-magnitude", "PIXELS", "slowest flow that gets a seed, in pixels per frame", {0, 10'000}};
inline constexpr Setting seed_area{"seed-area", "NAME", "where seeds may lie"};
inline constexpr Setting seed_order{"seed-order", "NAME", "which seeds come first"};
inline constexpr Setting seed_select{"seed-select", "HOW",
                                     "which seeds of a frame are kept: all, first:N or random:N[:NUMBER]"};
inline constexpr Setting seeds{.name = "seeds",
                               .unit = "PATH",
                               .help =
                                   "read seeds instead of computing them: a folder with a list for each frame, as "
                                   "`vvr extract` writes it, or one list that all frames share",
                               .may_be_file = true};
inline constexpr Setting seed_flags{
    .name = "seed-flags",
    .unit = "DIGITS",
    .help = "bricks whose seeds are drawn: a digit 0 or 1 per brick, repeated; 100 = every third brick",
    .default_text = "the seeds' own"};

inline constexpr Setting threads{
    "threads", "COUNT", "worker threads; 0 = one per core, shared by the clips of an archive", {0, 1024}};

}  // namespace vvr::setting

namespace vvr::fields {

/// Calls `each` for every setting of SeedOptions with the member that holds its value, and the table if that is the
/// name of a row. A number whose default depends on another setting has that setting's row, its table and the default
/// of a row. The options and the validation follow this list.
template <class Options, class Each>
void each_seed_setting(Options& options, const Each& each) {
    each(setting::grid, options.grid);
    each(setting::min_magnitude, options.min_magnitude);
    each(setting::seed_area, options.area, seed_areas());
    each(setting::seed_order, options.order, seed_orders());
    each(setting::seed_select, options.select);
}

/// The same for FieldOptions, without those that commands have in other groups: span, threads and FlowOptions::every.
template <class Options, class Each>
void each_field_setting(Options& options, const Each& each) {
    each(setting::field, options.given_folder);  // before the filter, which it must not replace if that is given too
    each(setting::filter, options.filter, filters());
    each(setting::reference, options.reference, reference_kinds());
    each(setting::norm, options.norm, norms());
    each(setting::threshold, options.threshold, options.filter, filters(),
         [](const FilterRow& row) { return row.traits.threshold; });
    each(setting::smooth, options.smooth);
    each(setting::min_area, options.min_area);
    each(setting::illumination, options.illumination, illuminations());
    each(setting::shadows, options.shadows, shadow_kinds());
    each(setting::stabilize, options.stabilize, stabilizers());
    each(setting::roi, options.roi);
    each(setting::mask, options.mask);
    each(setting::flow, options.flow.method, flow_methods());
    each(setting::solver, options.flow.solver, flow_solvers());
    each(setting::derivatives, options.flow.derivatives, derivative_kinds());
    each(setting::alpha, options.flow.alpha, options.flow.solver, flow_solvers(),
         [](const SolverRow& row) { return row.defaults.alpha; });
    each(setting::iterations, options.flow.iterations, options.flow.solver, flow_solvers(),
         [](const SolverRow& row) { return row.defaults.iterations; });
    each_seed_setting(options.seeds, each);
}

}  // namespace vvr::fields
