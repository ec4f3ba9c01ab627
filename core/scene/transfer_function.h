#pragma once

#include <array>
#include <cstdint>
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

}  // namespace vvr::scene
