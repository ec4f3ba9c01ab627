#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/fields/field.h"
#include "core/fields/options.h"

namespace vvr::fields {

/// A frame as a flow method wants it: made once a frame, used for the flow of every frame near it.
struct FlowFrame {
    Plane<std::uint8_t> grey;
    std::vector<Plane<float>> levels;  ///< what the method made of it: smoothed, and smaller from one to the next
};

/// A part of a picture: columns x to x + width - 1, rows y to y + height - 1.
struct Rect {
    int x = 0;
    int y = 0;
    Size size;

    friend bool operator==(const Rect&, const Rect&) = default;
};

/// Parts of a picture, none of which overlap, that hold all points that are not 0 and `margin` pixels about each: the
/// whole picture where that is most of it, none where all is 0.
std::vector<Rect> regions_around(const Plane<std::uint8_t>& object, int margin);

/// Estimates the optical flow of one frame from the frames about it.
class FlowMethod {
  public:
    virtual ~FlowMethod() = default;

    /// Frames needed on each side of the one whose flow is wanted.
    virtual int reach() const = 0;

    /// Pixels by which a part must be larger than what is wanted, so that what lies outside doesn't count.
    virtual int margin() const = 0;

    /// The part of the work that depends on one frame alone.
    virtual FlowFrame prepare(const Plane<std::uint8_t>& grey) const = 0;

    /// The flow in a part of the middle one of `frames`, which are 2 reach() + 1; past the clip's ends the end
    /// frame stands again. Called from several threads at once.
    virtual Flow operator()(std::span<const FlowFrame* const> frames, const Rect& part) const = 0;
};

/// One row of the flow table.
struct FlowRow {
    std::string_view name;
    std::string_view help;
    std::unique_ptr<FlowMethod> (*make)(const FlowOptions& options);
    bool is_none = false;  ///< computes nothing, so there are no seeds either
};

/// A kind of derivatives.
struct DerivativeRow {
    std::string_view name;
    std::string_view help;
    bool cube;  ///< as SolverSettings::cube
};

/// "barron" and "cube".
std::span<const DerivativeRow> derivative_kinds();

/// Every flow method, and one that computes nothing.
std::span<const FlowRow> flow_methods();

/// Whether the options ask for a method that computes something.
bool has_flow(const FlowOptions& options);

/// The method that computes nothing.
const FlowRow& no_flow();

/// Where in a frame flow is computed.
struct FlowArea {
    std::string_view name;
    std::string_view help;
    std::int64_t whole_up_to;  ///< clips of at most this many frames get flow in the whole frame
};
std::span<const FlowArea> flow_areas();

/// Whether flow is computed in the whole of each frame of a clip.
/// \param frames of the clip; 0 = unknown
bool is_whole_frame(const FlowOptions& options, std::int64_t frames);

/// The method that the options ask for; null where they ask for none.
/// \throws Error usage when a value is out of its range
std::unique_ptr<FlowMethod> make_flow(const FlowOptions& options);

std::unique_ptr<FlowMethod> make_horn_schunck(const FlowOptions& options);
std::unique_ptr<FlowMethod> make_dis(const FlowOptions& options);
std::unique_ptr<FlowMethod> make_farneback(const FlowOptions& options);

/// What a solver of Horn and Schunck's equations is told.
struct SolverSettings {
    double alpha = 0;
    int iterations = 0;
    double pre_smooth = 0;  ///< σ in pixels and frames
    bool cube = false;      ///< derivatives of the cube of 2×2×2 values in place of Barron's
};

/// One row of the solver table, with its defaults.
struct SolverRow {
    std::string_view name;
    std::string_view help;
    SolverSettings defaults;
    std::unique_ptr<FlowMethod> (*make)(const SolverSettings& settings);
};

std::span<const SolverRow> flow_solvers();

/// The paper's: Jacobi steps from zero.
std::unique_ptr<FlowMethod> make_jacobi(const SolverSettings& settings);

/// Coarse to fine: at each scale `iterations` times the second frame is warped by the flow so far and the equations
/// solved again, after Meinhardt-Llopis, Sánchez and Kondermann (Image Processing On Line, 2013). Follows motion of
/// many pixels per frame.
std::unique_ptr<FlowMethod> make_pyramid(const SolverSettings& settings);

}  // namespace vvr::fields
