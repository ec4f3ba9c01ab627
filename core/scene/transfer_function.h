#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "core/bricks/cells.h"

namespace vvr::scene {

/// A point of a transfer function: a scalar value in 0..255, its colour (sRGB, 0..1) and its extinction, the
/// opacity per unit length of P-space: a slab of extinction σ and length L lets exp(-σL) through.
struct TransferPoint {
    double value = 0;
    glm::dvec3 colour{0};
    double extinction = 0;
};

/// Scalar value to colour and extinction, linear between its points.
class TransferFunction {
  public:
    /// \param points ascending in value; the first and last hold beyond their ends
    explicit TransferFunction(std::vector<TransferPoint> points);

    /// Colour (xyz) and extinction (w) of a value in 0..255.
    glm::dvec4 at(double value) const;

    /// Whether any value in the range has extinction.
    bool visible(const bricks::ValueRange& range) const;

    /// The same function with all extinctions multiplied.
    TransferFunction scaled(double opacity) const;

    const std::vector<TransferPoint>& points() const { return points_; }

  private:
    std::vector<TransferPoint> points_;
    std::array<int, 257> visible_below_{};  ///< how many of the values 0..i-1 or the steps to them have extinction
};

/// What moved, from faint to strong.
TransferFunction default_transfer_function();

/// A transfer function that has a name.
struct TransferRow {
    std::string name;
    std::string help;
    std::vector<TransferPoint> points;
};

/// The named transfer functions; the first is the default.
const std::vector<TransferRow>& transfer_functions();

/// The opacity of a transfer file is that of a layer so thick, in P-space units: a fiftieth of the horseshoe's outer
/// radius, about as thick as a person's track.
inline constexpr double opacity_unit_distance = 0.02;

/// Extinction per P-space unit of what lets 1 - `opacity` through `opacity_unit_distance`. Opacity 1 would be infinite;
/// from 0.999 on it counts as that.
double extinction_of(double opacity);

/// Reads a transfer function: a line for each point, `value red green blue opacity`, with blanks or commas between
/// them and `#` before a comment. Values 0..255 ascend; the others are 0..1, colours sRGB.
/// \param name stands in messages
/// \throws Error usage with the line, what was found and what is allowed
TransferFunction parse_transfer(const std::string& text, const std::string& name);

/// The transfer function of that name, or else in that file.
/// \throws Error usage as `parse_transfer` and for what is neither name nor file, io for a file that can't be read
TransferFunction find_transfer(const std::string& name_or_file);

}  // namespace vvr::scene
