#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/video/frame_span.h"

namespace vvr::fields {

/// §4.1. Units: pixels of the field, grey levels 0..255.
struct FlowOptions {
    std::string method = "horn-schunck";  ///< a name in the flow table, or "none"
    std::string solver = "pyramid";       ///< a name in the solver table
    std::string derivatives = "barron";   ///< "barron" or "cube", for the solver jacobi
    std::optional<double> alpha{};  ///< weight of smoothness (the paper's "λ = 100" is α² = 100); else the solver's
    std::optional<int> iterations{};     ///< steps or warps; else the solver's
    std::optional<double> pre_smooth{};  ///< σ of the Gaussian before derivatives, 0 = none; else the solver's
    std::int64_t every = 1;              ///< flow and seeds at frames whose index is a multiple of it
    bool every_frame = false;            ///< flow, not seeds, at all frames
    std::string area = "auto";           ///< a name in the table of flow areas
};

/// §4.2's three phases: points of a grid that move, put in an order, and some of them taken.
struct SeedOptions {
    int grid = 14;                    ///< grid interval in field pixels
    double min_magnitude = 0.3;       ///< pixels per frame
    std::string area = "object";      ///< a name in the table of seed areas
    std::string order = "magnitude";  ///< a name in the table of seed orders
    std::string select = "all";       ///< "all", "first:N", or "random:N" or "random:N:NUMBER" with a seed number
};

struct FieldOptions {
    std::string filter = "difference";    ///< a name in the filter table
    std::string second{};                 ///< another one, with its own default threshold; empty = none
    std::string reference = "median";     ///< a name in the reference table, or a picture file
    std::string norm = "channel";         ///< a name in the table of norms
    std::optional<int> threshold{};       ///< grey levels; values below it become 0; else the filter's own
    double smooth = 0.7;                  ///< σ in field pixels of the smoothing before a comparison, 0 = none
    int min_area = 20;                    ///< field pixels; blobs of fewer become 0
    std::string illumination = "global";  ///< a name in the illumination table: changes of light that don't count
    std::string shadows = "remove";       ///< a name in the table of shadows: whether cast shadows count as objects
    std::string stabilize = "auto";       ///< a name in the table of stabilizers: what to do when the camera shakes
    std::string roi{};                    ///< where to look: polygons or a picture; empty = everywhere
    std::string mask{};                   ///< where not to look: polygons or a picture; empty = nowhere
    FlowOptions flow{};
    SeedOptions seeds{};
    video::FrameSpan span{};  ///< frames beside it serve as neighbours, but give no field
    int threads = 0;          ///< 0 = one for each core
};

/// Checks every value and every name; `compute_fields` does so first.
/// \throws Error usage with the setting, what was found and what is allowed
void validate(const FieldOptions& options);

}  // namespace vvr::fields
