#pragma once

#include <cstdint>
#include <string>

namespace vvr {

/// §4.1. Units: pixels of the field, grey levels 0..255.
struct FlowOptions {
    std::string method = "horn-schunck";  ///< a name in the flow table, or "none"
    double alpha = 10;                    ///< weight of smoothness; the paper's "λ = 100" is α² = 100
    int iterations = 60;
    double pre_smooth = 1.5;  ///< σ of the Gaussian before derivatives, in x, y and t; 0 = none
    std::int64_t every = 1;   ///< flow and seeds at frames whose index is a multiple of it
};

/// §4.2's three phases.
struct SeedOptions {
    int grid = 12;               ///< grid interval in field pixels
    double min_magnitude = 0.3;  ///< pixels a frame
};

struct FieldOptions {
    std::string filter = "difference";  ///< a name in the filter table
    std::string reference = "median";   ///< a name in the reference table, or a picture file
    int threshold = 24;                 ///< grey levels; differences below it become 0
    FlowOptions flow{};
    SeedOptions seeds{};
    int threads = 0;  ///< 0 = one for each core
};

}  // namespace vvr
