#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/fields/field.h"
#include "core/fields/options.h"

namespace vvr {

/// A frame as a flow method wants it: made once a frame, used for the flow of every frame near it.
struct FlowFrame {
    Plane<std::uint8_t> grey;
    Plane<float> smooth;  ///< what `FlowMethod::prepare` made of it
};

/// Estimates the optical flow of one frame from the frames about it.
class FlowMethod {
  public:
    virtual ~FlowMethod() = default;

    /// Frames needed on each side of the one whose flow is wanted.
    virtual int reach() const = 0;

    /// The part of the work that depends on one frame alone.
    virtual Plane<float> prepare(const Plane<std::uint8_t>& grey) const = 0;

    /// The flow of the middle one of `frames`, which are 2 reach() + 1; past the clip's ends the end frame stands
    /// again. Called from several threads at once.
    virtual Flow operator()(std::span<const FlowFrame* const> frames) const = 0;
};

/// One row of the flow table.
struct FlowRow {
    std::string_view name;
    std::string_view help;
    std::unique_ptr<FlowMethod> (*make)(const FlowOptions& options);
};

/// Every flow method; "none", which makes nothing, among them.
std::span<const FlowRow> flow_methods();

/// The method that the options ask for; null for "none".
/// \throws Error usage when there is no such method
std::unique_ptr<FlowMethod> make_flow(const FlowOptions& options);

/// Horn and Schunck's method as the paper has it (§4.1): derivatives after Barron, Fleet and Beauchemin 1994, Jacobi
/// steps from zero.
std::unique_ptr<FlowMethod> make_horn_schunck(const FlowOptions& options);

}  // namespace vvr
