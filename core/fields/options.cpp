#include "core/fields/options.h"

#include <fmt/format.h>

#include "core/base/choice.h"
#include "core/base/error.h"
#include "core/fields/filter.h"
#include "core/fields/flow.h"
#include "core/fields/illumination.h"
#include "core/fields/norm.h"
#include "core/fields/reference.h"
#include "core/fields/region.h"
#include "core/fields/seeds.h"
#include "core/fields/settings.h"
#include "core/fields/shadows.h"
#include "core/fields/solvers.h"
#include "core/fields/stabilizer.h"

namespace vvr::fields {
namespace {

void validate(const FlowOptions& flow) {
    choose(setting::flow.name, flow.method, flow_methods());
    choose(setting::flow_area.name, flow.area, flow_areas());
    choose(setting::solver.name, flow.solver, flow_solvers());
    choose(setting::derivatives.name, flow.derivatives, derivative_kinds());
    if (flow.alpha) check(setting::alpha, *flow.alpha);
    if (flow.iterations) check(setting::iterations, *flow.iterations);
    if (flow.pre_smooth) check(setting::pre_smooth, *flow.pre_smooth);
    check(setting::flow_every, flow.every);
}

void validate(const SeedOptions& seeds) {
    check(setting::grid, seeds.grid);
    check(setting::min_magnitude, seeds.min_magnitude);
    choose(setting::seed_area.name, seeds.area, seed_areas());
    choose(setting::seed_order.name, seeds.order, seed_orders());
    parse_seed_selection(seeds.select);
}

void validate(const video::FrameSpan& span) {
    // Written so that a NaN is refused.
    if (!(span.start >= 0) || span.first < 0) {
        throw Error(
            ErrorKind::usage,
            fmt::format("start: {} is before the clip", span.first < 0 ? static_cast<double>(span.first) : span.start),
            {setting::start.name});
    }
    if ((span.end && *span.end <= span.start) || (span.stop && *span.stop <= span.first)) {
        throw Error(ErrorKind::usage, "end has to come after the start", {setting::end.name});
    }
}

}  // namespace

void validate(const FieldOptions& options) {
    find_filter(options.filter);
    if (!options.second.empty()) find_filter(options.second);
    choose(setting::norm.name, options.norm, norms());
    choose(setting::illumination.name, options.illumination, illuminations());
    choose(setting::shadows.name, options.shadows, shadow_kinds());
    choose(setting::stabilize.name, options.stabilize, stabilizers());
    if (options.threshold) check(setting::threshold, *options.threshold);
    check(setting::smooth, options.smooth);
    check(setting::min_area, options.min_area);
    check(setting::threads, options.threads);
    validate(options.span);
    validate(options.flow);
    validate(options.seeds);
    validate_reference(options.reference);
    validate_region(setting::roi.name, options.roi);
    validate_region(setting::mask.name, options.mask);
}

}  // namespace vvr::fields
