#pragma once

#include <cstddef>

namespace vvr::fields {

/// Neighbouring pixels of one row that belong to one track: columns first to last - 1.
struct LabelRun {
    int row = 0;
    int first = 0;
    int last = 0;
    std::size_t track = 0;
};

}  // namespace vvr::fields
