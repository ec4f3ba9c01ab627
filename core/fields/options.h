#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/plane.h"
#include "core/base/setting.h"
#include "core/media/frame_span.h"

namespace vvr::fields {

struct FlowRow;
struct ReferenceRow;

// The rows that settings name; each table is in its own header.
const struct DerivativeRow& row_of(Name<struct DerivativeRow> name);
const struct FilterRow& row_of(Name<struct FilterRow> name);
const struct IlluminationRow& row_of(Name<struct IlluminationRow> name);
const struct NormRow& row_of(Name<struct NormRow> name);
const struct SeedAreaRow& row_of(Name<struct SeedAreaRow> name);
const struct SeedOrderRow& row_of(Name<struct SeedOrderRow> name);
const struct ShadowRow& row_of(Name<struct ShadowRow> name);
const struct SolverRow& row_of(Name<struct SolverRow> name);
const struct StabilizerRow& row_of(Name<struct StabilizerRow> name);

/// The source of the flow: a method, or a folder of .flo files.
class FlowChoice {
  public:
    static constexpr std::string_view or_file = ", or a folder of .flo files, one per frame";

    /// \throws Error usage for a name that is neither in the table nor that of a file
    FlowChoice(std::string name);
    FlowChoice(const char* name) : FlowChoice(std::string(name)) {}

    /// The method that computes nothing.
    static FlowChoice none();

    const FlowRow& row() const { return *row_; }
    const std::string& name() const { return name_; }  ///< of the row or the folder
    bool is_folder() const;

  private:
    explicit FlowChoice(const FlowRow& row);

    std::string name_;
    const FlowRow* row_;
};

/// Options of optical flow (§4.1). Units: field pixels, grey levels 0 to 255.
struct FlowOptions {
    FlowChoice method = "horn-schunck";
    Choice<SolverRow> solver = "pyramid";
    Choice<DerivativeRow> derivatives = "barron";  ///< for the solver jacobi
    std::optional<double> alpha{};  ///< weight of smoothness (the paper's "λ = 100" is α² = 100); else the solver's
    std::optional<int> iterations{};  ///< iterations or warps; else the solver's
    std::int64_t every = 1;           ///< flow and seeds at frames whose number is a multiple of this
    bool every_frame = false;         ///< flow (not seeds) at all frames
};

/// Which of the ordered points become seeds.
struct SeedSelection {
    enum class Kind { all, first, random } kind = Kind::all;
    std::size_t count = 0;
    std::uint64_t number = 1;  ///< initial state of the random numbers
};

/// The three phases of §4.2: find moving grid points, order them, select some.
struct SeedOptions {
    int grid = 14;               ///< grid interval in field pixels
    double min_magnitude = 0.3;  ///< pixels per frame
    Choice<SeedAreaRow> area = "object";
    Choice<SeedOrderRow> order = "magnitude";
    SeedSelection select{};
};

/// The source of the empty scene.
class ReferenceChoice {
  public:
    static constexpr std::string_view or_file = ", or a picture file of it";

    /// \throws Error usage for a name that is neither in the table nor that of a file
    ReferenceChoice(std::string name);
    ReferenceChoice(const char* name) : ReferenceChoice(std::string(name)) {}

    const ReferenceRow* row() const { return row_; }   ///< null = a picture file
    const std::string& name() const { return name_; }  ///< of the row or the picture file

  private:
    std::string name_;
    const ReferenceRow* row_;
};

/// Reads one 8-bit value per pixel from a picture of this size.
using ReadScalar = Plane<std::uint8_t>(const std::filesystem::path& file, Size size);

struct FieldOptions {
    Choice<FilterRow> filter = "difference";
    std::string given_folder{};         ///< for the filter "given": a picture per frame, by the frame's number
    ReadScalar* read_given = nullptr;   ///< of core/dataset, which knows pictures
    const FilterRow* second = nullptr;  ///< second filter, with its own default threshold; null = none
    ReferenceChoice reference = "median";
    Choice<NormRow> norm = "channel";                 ///< distance between two colours
    std::optional<int> threshold{};                   ///< grey levels; smaller values become 0; else the filter's own
    double smooth = 0.7;                              ///< Gaussian σ before a comparison, field pixels; 0 = none
    int min_area = 20;                                ///< field pixels; smaller blobs become 0
    Choice<IlluminationRow> illumination = "global";  ///< changes of light that are compensated
    Choice<ShadowRow> shadows = "remove";             ///< what to do with cast shadows
    Choice<StabilizerRow> stabilize = "auto";         ///< what to do when the camera shakes
    std::string roi{};                                ///< polygons or a picture of where to look; empty = everywhere
    std::string mask{};                               ///< polygons or a picture of what to ignore; empty = nothing
    std::vector<PixelBox> overlays{};                 ///< the camera's clocks, field pixels; ignored like the mask
    FlowOptions flow{};
    SeedOptions seeds{};
    media::FrameSpan span{};  ///< frames outside serve as neighbours only
    int threads = 0;          ///< 0 = one per core
    bool full_size = false;   ///< frames refer to their decoded pictures, for `media::crop_of`
};

/// Checks every value. `compute_fields` calls it first.
/// \throws Error usage with the setting, the value found and the allowed ones
void validate(const FieldOptions& options);

}  // namespace vvr::fields
