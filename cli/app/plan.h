#pragma once

#include <cstdint>

#include "cli/app/job.h"
#include "core/fields/field_source.h"

namespace vvr::app {

/// What a render is going to do, if the clip has as many frames as its container says.
struct Plan {
    std::int64_t frames = 0;  ///< 0 = unknown
    std::int64_t step = 1;    ///< frames per layer
    std::int64_t layers = 0;
    std::int64_t bricks = 0;
    std::int64_t bytes = 0;  ///< estimate of the most memory that it can take, with something everywhere
};

Plan make_plan(const RenderJob& job, const Products& products, const fields::FieldSource& source);

/// \throws Error limit when the machine has less memory than that, where the system would kill the program half way
void check_memory(const Plan& plan);

}  // namespace vvr::app
