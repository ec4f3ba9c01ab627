#include "core/fields/options.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.h"
#include "core/fields/choice.h"
#include "core/fields/filter.h"
#include "core/fields/flow.h"
#include "core/fields/flows/solvers.h"
#include "core/fields/illumination.h"
#include "core/fields/reference.h"
#include "core/fields/region.h"
#include "core/fields/seeds.h"
#include "core/fields/shadows.h"
#include "core/fields/stabilizer.h"

namespace vvr {
namespace {

// Written so that a NaN is out of range.
template <class T>
void check_range(const char* option, T found, T least, T most) {
    if (found >= least && found <= most) return;
    throw Error(ErrorKind::usage, fmt::format("{}: {} is not between {} and {}", option, found, least, most));
}

void validate(const FlowOptions& flow) {
    choose("--flow", flow.method, flow_methods());
    choose("--flow-area", flow.area, flow_areas());
    choose("--solver", flow.solver, flow_solvers());
    choose("--derivatives", flow.derivatives, derivative_kinds());
    // Less than this and float can't hold α² beside the squares of the derivatives.
    if (flow.alpha) check_range("--alpha", *flow.alpha, 0.01, 10000.0);
    if (flow.iterations) check_range("--iterations", *flow.iterations, 1, 100000);
    if (flow.pre_smooth) check_range("--pre-smooth", *flow.pre_smooth, 0.0, 5.0);
    check_range<std::int64_t>("flow interval", flow.every, 1, std::numeric_limits<std::int64_t>::max());
}

}  // namespace

void validate(const FieldOptions& options) {
    find_filter(options.filter);
    choose("--illumination", options.illumination, illuminations());
    choose("--shadows", options.shadows, shadow_kinds());
    choose("--stabilize", options.stabilize, stabilizers());
    if (options.threshold) check_range("--threshold", *options.threshold, 0, 255);
    check_range("--smooth", options.smooth, 0.0, 20.0);
    check_range("--min-area", options.min_area, 0, 1000000);
    check_range("--threads", options.threads, 0, 4096);
    check_range("--start", options.span.start, 0.0, std::numeric_limits<double>::max());
    if (options.span.end)
        check_range("--end", *options.span.end, options.span.start, std::numeric_limits<double>::max());
    constexpr std::int64_t last = std::numeric_limits<std::int64_t>::max();
    check_range<std::int64_t>("--start", options.span.first, 0, last);
    if (options.span.stop) check_range("--end", *options.span.stop, options.span.first, last);
    validate(options.flow);
    check_range("--grid", options.seeds.grid, 1, 10000);
    check_range("--min-magnitude", options.seeds.min_magnitude, 0.0, 10000.0);
    choose("--seed-order", options.seeds.order, seed_orders());
    parse_seed_selection(options.seeds.select);
    validate_reference(options.reference);
    validate_region("--roi", options.roi);
    validate_region("--mask", options.mask);
}

}  // namespace vvr
