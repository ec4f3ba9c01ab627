#include "cli/options/fields.h"

#include <fmt/format.h>

#include "cli/options/option.h"
#include "core/fields/filter.h"
#include "core/fields/flow.h"
#include "core/fields/flows/solvers.h"
#include "core/fields/illumination.h"
#include "core/fields/reference.h"
#include "core/fields/seeds.h"
#include "core/fields/shadows.h"
#include "core/fields/stabilizer.h"

namespace vvr {

namespace {

void add_filter_options(CLI::App& app, FieldOptions& options) {
    add_choice(app, group::fields, options.filter, filters(), {"--filter", "NAME", "", "what counts as interesting"});
    explain(app, "--reference", reference_kinds());
    add_text(app, group::fields, options.reference,
             {"--reference", "NAME", "",
              fmt::format("the empty scene: {}, or a picture file", fmt::join(names_of(reference_kinds()), ", "))});
    add_integer(app, group::fields, options.threshold, 0, 255,
                {"--threshold", "GREY", "the filter's", "grey levels; what differs less becomes 0"});
    add_number(app, group::fields, options.smooth, {0, 20},
               {"--smooth", "PIXELS", "", "Gaussian smoothing before a comparison"});
    add_integer(app, group::fields, options.min_area, 0, 1'000'000,
                {"--min-area", "PIXELS", "", "blobs of fewer field pixels are noise"});
    add_choice(app, group::fields, options.illumination, illuminations(),
               {"--illumination", "NAME", "", "changes of light that don't count"});
    add_choice(app, group::fields, options.shadows, shadow_kinds(), {"--shadows", "NAME", "", "cast shadows"});
    add_choice(app, group::fields, options.stabilize, stabilizers(),
               {"--stabilize", "NAME", "", "a camera that shakes"});
    add_text(app, group::fields, options.roi,
             {"--roi", "AREA", "", "look only here: 'x,y x,y x,y; ...' in pixels of the video, or a picture"});
    add_text(app, group::fields, options.mask, {"--mask", "AREA", "", "don't look here, the camera's clock say"});
}

void add_flow_options(CLI::App& app, FlowOptions& options) {
    add_choice(app, group::fields, options.method, flow_methods(), {"--flow", "NAME", "", "optical flow"});
    add_choice(app, group::fields, options.area, flow_areas(), {"--flow-area", "NAME", "", "where flow is looked for"});
    add_choice(app, group::fields, options.solver, flow_solvers(), {"--solver", "NAME", "", "of horn-schunck"});
    add_choice(app, group::fields, options.derivatives, derivative_kinds(),
               {"--derivatives", "NAME", "", "of horn-schunck, not with the solver pyramid"});
    add_number(app, group::fields, options.alpha, {0.01, 10'000},
               {"--alpha", "NUMBER", "the solver's", "weight of smooth flow (the paper's λ is its square)"});
    add_integer(app, group::fields, options.iterations, 1, 100'000,
                {"--iterations", "COUNT", "the solver's", "steps, cycles or warps"});
    add_number(app, group::fields, options.pre_smooth, {0, 5},
               {"--pre-smooth", "PIXELS", "the solver's", "Gaussian smoothing before derivatives"});
}

void add_seed_options(CLI::App& app, SeedOptions& options) {
    add_integer(app, group::fields, options.grid, 1, 10000, {"--grid", "PIXELS", "", "interval between seeds"});
    add_number(app, group::fields, options.min_magnitude, {0, 10'000},
               {"--min-magnitude", "PIXELS", "", "flow a frame below which there is no seed"});
    add_choice(app, group::fields, options.order, seed_orders(),
               {"--seed-order", "NAME", "", "which seeds come first"});
    add_text(app, group::fields, options.select,
             {"--seed-select", "HOW", "", "all, first:N a frame, or random:N[:NUMBER]"});
}

}  // namespace

void add_options(CLI::App& app, FieldOptions& options) {
    add_filter_options(app, options);
    add_flow_options(app, options.flow);
    add_seed_options(app, options.seeds);
}

}  // namespace vvr
