#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "core/volume/cells.h"

namespace vvr::scene {

/// A point of a transfer function: a scalar value in 0..255, its colour (sRGB, 0..1) and its extinction σ per P-space
/// unit. A slab of thickness L transmits exp(-σL).
struct TransferPoint {
    double value = 0;
    glm::dvec3 colour{0};
    double extinction = 0;
};

/// Maps scalar values to colour and extinction, linearly between its points.
class TransferFunction {
  public:
    /// \param points ascending in value; the function is constant before the first and after the last
    /// \throws Error usage for no points, descending values, or extinctions that are negative or not finite
    explicit TransferFunction(std::vector<TransferPoint> points);

    /// Colour (xyz, sRGB) and extinction (w) of a value in 0..255.
    glm::dvec4 at(double value) const;

    /// Whether any value in the range has an extinction above zero.
    bool visible(const volume::ValueRange& range) const;

    /// The function with all extinctions multiplied by `opacity`.
    TransferFunction scaled(double opacity) const;

    const std::vector<TransferPoint>& points() const { return points_; }

  private:
    std::vector<TransferPoint> points_;
    std::array<int, 257> visible_below_{};  ///< prefix sums: number of visible values below i
};

/// Blue, from faint to strong differences.
TransferFunction default_transfer_function();

/// A named transfer function.
struct TransferRow {
    std::string name;
    std::string help;
    std::vector<TransferPoint> points;
};

/// The first row is the default.
const std::vector<TransferRow>& transfer_functions();

/// Transfer files give the opacity of a layer of this thickness, in P-space units: a fiftieth of the horseshoe's outer
/// radius, about as thick as a person's track.
inline constexpr double opacity_unit_distance = 0.02;

/// Converts the opacity of a layer of `opacity_unit_distance` to extinction per P-space unit. Opacities above 0.999 are
/// clamped, because 1 would need infinite extinction.
double extinction_of(double opacity);

/// Parses a transfer function: one point per line, `value red green blue opacity`, separated by blanks or commas; `#`
/// starts a comment. Values 0..255 ascend; the other numbers are 0..1, colours in sRGB.
/// \param name name of the file, for messages
/// \throws Error usage for an invalid line; the message has the line, what was found and what is allowed
TransferFunction parse_transfer(const std::string& text, const std::string& name);

/// The transfer function with that name, or else from that file.
/// \throws Error usage as `parse_transfer`, or if it is neither a name nor a file; io if the file can't be read
TransferFunction find_transfer(const std::string& name_or_file);

}  // namespace vvr::scene
