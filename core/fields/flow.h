#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/fields/field.h"
#include "core/fields/frame_files.h"
#include "core/fields/options.h"

namespace vvr::fields {

/// A frame prepared for a flow method, once per frame, and used for all frames nearby.
struct FlowFrame {
    Plane<std::uint8_t> grey;
    std::vector<Plane<float>> levels;  ///< the method's planes: smoothed, or the levels of an image pyramid
    std::int64_t index = 0;            ///< of the frame in the clip
};

/// Parts of a picture that contain all pixels other than 0, each with `margin` pixels around it. Parts don't overlap.
/// The whole picture if they would cover most of it; none if all pixels are 0.
std::vector<PixelBox> regions_around(const Plane<std::uint8_t>& object, int margin);

/// Estimates the optical flow of one frame from its neighbours.
class FlowMethod {
  public:
    virtual ~FlowMethod() = default;

    /// Number of frames needed on each side.
    virtual int reach() const = 0;

    /// Width in pixels of the border around a part whose pixels affect the flow in the part.
    virtual int margin() const = 0;

    /// The part of the work that depends on one frame alone.
    virtual FlowFrame prepare(const Plane<std::uint8_t>& grey) const = 0;

    /// The flow in a part of the middle frame. Thread-safe.
    /// \param frames 2 reach() + 1 frames; beyond the clip's ends the end frame is repeated
    virtual Flow operator()(std::span<const FlowFrame* const> frames, const PixelBox& part) const = 0;
};

/// One row of the table of flow methods.
struct FlowRow {
    std::string_view name;
    std::string_view help;
    std::unique_ptr<FlowMethod> (*make)(const FlowOptions& options);
    bool is_none = false;  ///< computes nothing, so there are no seeds
};

/// A kind of derivatives.
struct DerivativeRow {
    std::string_view name;
    std::string_view help;
    bool cube;  ///< as SolverSettings::cube
};

/// "barron" and "cube".
std::span<const DerivativeRow> derivative_kinds();

/// All flow methods, and the one that computes nothing.
std::span<const FlowRow> flow_methods();

/// Whether the chosen method computes flow.
bool has_flow(const FlowOptions& options);

/// The method that computes nothing.
const FlowRow& no_flow();

/// Whether a clip has so few frames that flow is computed everywhere. Benchmark sequences are that short, and have no
/// empty scene. In others it is computed only near visible pixels that change.
///
/// \param frames of the clip; 0 = unknown
bool is_short(std::int64_t frames);

/// The chosen method; null for none.
/// \throws Error usage if a value is out of range
std::unique_ptr<FlowMethod> make_flow(const FlowOptions& options);

std::unique_ptr<FlowMethod> make_horn_schunck(const FlowOptions& options);
std::unique_ptr<FlowMethod> make_dis(const FlowOptions& options);
std::unique_ptr<FlowMethod> make_farneback(const FlowOptions& options);

/// The flow of the .flo files in the folder that the method names.
/// \throws Error io if the folder has none
std::unique_ptr<FlowMethod> make_stored_flow(const FlowOptions& options);

/// The .flo files of a folder, by frame. The first frame may have none, and so may the last.
/// \throws Error io if there is none
FrameFiles open_flow_files(const std::filesystem::path& folder);

/// The settings of a solver of Horn and Schunck's equations.
struct SolverSettings {
    double alpha = 0;
    int iterations = 0;
    bool cube = false;  ///< finite differences over a cube of 2×2×2 values instead of Barron's
};

/// One row of the table of solvers, with defaults.
struct SolverRow {
    std::string_view name;
    std::string_view help;
    SolverSettings defaults;
    std::unique_ptr<FlowMethod> (*make)(const SolverSettings& settings);
};

std::span<const SolverRow> flow_solvers();

/// Coarse-to-fine solver on an image pyramid, for motion of many pixels per frame: at each level, warps the second
/// frame by the current flow and solves the equations again, `iterations` times (Meinhardt-Llopis, Sánchez and
/// Kondermann, Image Processing On Line, 2013).
std::unique_ptr<FlowMethod> make_pyramid(const SolverSettings& settings);

}  // namespace vvr::fields
