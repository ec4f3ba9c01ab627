#include "cli/options_fields.h"

#include "cli/option.h"
#include "core/fields/filter.h"
#include "core/fields/flow.h"

namespace vvr {

void add_options(CLI::App& app, FieldOptions& options) {
    add_name(app, group::fields, options.filter, names_of(filters()),
             {"--filter", "NAME", "", "what counts as interesting"});
    add_option(app, group::fields, options.reference,
               {"--reference", "NAME", options.reference, "the empty scene: median, or a picture file"},
               [](const std::string& given) { return given; });
    add_integer(app, group::fields, options.threshold, 0, 255,
                {"--threshold", "GREY", "", "grey levels; what differs less becomes 0"});
    add_name(app, group::fields, options.flow.method, names_of(flow_methods()), {"--flow", "NAME", "", "optical flow"});
    add_number(app, group::fields, options.flow.alpha, {1e-3, 1e6},
               {"--alpha", "NUMBER", "", "weight of smooth flow (the paper's λ is its square)"});
    add_integer(app, group::fields, options.flow.iterations, 1, 100'000,
                {"--iterations", "COUNT", "", "steps of the flow's solver"});
    add_integer(app, group::fields, options.seeds.grid, 1, 16384, {"--grid", "PIXELS", "", "interval between seeds"});
    add_number(app, group::fields, options.seeds.min_magnitude, {0, 16384},
               {"--min-magnitude", "PIXELS", "", "flow a frame below which there is no seed"});
}

}  // namespace vvr
