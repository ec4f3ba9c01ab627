#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/choice.h"
#include "core/video/frame_span.h"

namespace vvr::fields {

struct ReferenceRow;

// What settings name: rows of tables, each in the header of its table.
const struct DerivativeRow& row_of(Name<struct DerivativeRow> name);
const struct FilterRow& row_of(Name<struct FilterRow> name);
const struct FlowArea& row_of(Name<struct FlowArea> name);
const struct FlowRow& row_of(Name<struct FlowRow> name);
const struct IlluminationRow& row_of(Name<struct IlluminationRow> name);
const struct NormRow& row_of(Name<struct NormRow> name);
const struct SeedAreaRow& row_of(Name<struct SeedAreaRow> name);
const struct SeedOrderRow& row_of(Name<struct SeedOrderRow> name);
const struct ShadowRow& row_of(Name<struct ShadowRow> name);
const struct SolverRow& row_of(Name<struct SolverRow> name);
const struct StabilizerRow& row_of(Name<struct StabilizerRow> name);

/// §4.1. Units: pixels of the field, grey levels 0..255.
struct FlowOptions {
    Choice<FlowRow> method = "horn-schunck";
    Choice<SolverRow> solver = "pyramid";
    Choice<DerivativeRow> derivatives = "barron";  ///< of the solver jacobi
    std::optional<double> alpha{};  ///< weight of smoothness (the paper's "λ = 100" is α² = 100); else the solver's
    std::optional<int> iterations{};     ///< steps or warps; else the solver's
    std::optional<double> pre_smooth{};  ///< σ of the Gaussian before derivatives, 0 = none; else the solver's
    std::int64_t every = 1;              ///< flow and seeds at frames whose index is a multiple of it
    bool every_frame = false;            ///< flow, not seeds, at all frames
    Choice<FlowArea> area = "auto";
};

/// How many of the points in order are taken.
struct SeedSelection {
    enum class Kind { all, first, random } kind = Kind::all;
    std::size_t count = 0;
    std::uint64_t number = 1;  ///< for random: another one, other points
};

/// §4.2's three phases: points of a grid that move, put in an order, and some of them taken.
struct SeedOptions {
    int grid = 14;               ///< grid interval in field pixels
    double min_magnitude = 0.3;  ///< pixels per frame
    Choice<SeedAreaRow> area = "object";
    Choice<SeedOrderRow> order = "magnitude";
    SeedSelection select{};
};

/// Where the empty scene comes from.
class ReferenceChoice {
  public:
    /// \throws Error usage for what is neither in the table nor the name of a file
    ReferenceChoice(std::string name);
    ReferenceChoice(const char* name) : ReferenceChoice(std::string(name)) {}

    const ReferenceRow* row() const { return row_; }   ///< null = a picture
    const std::string& name() const { return name_; }  ///< of the row, or of the picture's file

  private:
    std::string name_;
    const ReferenceRow* row_;
};

struct FieldOptions {
    Choice<FilterRow> filter = "difference";
    const FilterRow* second = nullptr;  ///< another one, with its own default threshold; null = none
    ReferenceChoice reference = "median";
    Choice<NormRow> norm = "channel";  ///< how much two colours differ
    std::optional<int> threshold{};    ///< grey levels; values below it become 0; else the filter's own
    double smooth = 0.7;               ///< σ in field pixels of the smoothing before a comparison, 0 = none
    int min_area = 20;                 ///< field pixels; blobs of fewer become 0
    Choice<IlluminationRow> illumination = "global";  ///< changes of light that don't count
    Choice<ShadowRow> shadows = "remove";             ///< whether cast shadows count as objects
    Choice<StabilizerRow> stabilize = "auto";         ///< what to do when the camera shakes
    std::string roi{};                                ///< where to look: polygons or a picture; empty = everywhere
    std::string mask{};                               ///< where not to look: polygons or a picture; empty = nowhere
    FlowOptions flow{};
    SeedOptions seeds{};
    video::FrameSpan span{};  ///< frames beside it serve as neighbours, but give no field
    int threads = 0;          ///< 0 = one for each core
};

/// Checks every value; `compute_fields` does so first.
/// \throws Error usage with the setting, what was found and what is allowed
void validate(const FieldOptions& options);

}  // namespace vvr::fields
