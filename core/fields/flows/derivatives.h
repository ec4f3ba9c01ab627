#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/fields/flow.h"
#include "core/fields/flows/plane_stack.h"

namespace vvr::fields {

/// Planes of the stacks below: derivatives of the grey level along x and y (levels per pixel) and t (levels per frame).
enum DerivativePlane { along_x, along_y, along_t, derivative_planes };

/// A derivative from five points.
inline constexpr std::array five_point{1.F / 12, -8.F / 12, 0.F, 8.F / 12, -1.F / 12};

/// A Gaussian's taps, 3σ to each side, their sum 1; a single 1 for σ = 0.
std::vector<float> gaussian_taps(double sigma);

/// The five-point derivative of what was smoothed with `taps`, as one set of taps, two longer on each side.
std::vector<float> differentiated_taps(std::span<const float> taps);

/// Smoothed along rows and columns, in float: rounding to 8 bits would cost 6 to 10° of flow. Edges repeat.
Plane<float> smoothed(const Plane<std::uint8_t>& grey, std::span<const float> taps);
Plane<float> smoothed(const Plane<float>& plane, std::span<const float> taps);

/// Derivatives after Barron, Fleet and Beauchemin (1994): frames that are smoothed along x and y already are smoothed
/// along t with `taps`, then differentiated with (1, -8, 0, 8, -1)/12 along each axis.
/// \param frames as many as `differentiated_taps(taps)` has; the part's derivatives are those of the middle one
void barron_derivatives(std::span<const Plane<float>* const> frames, std::span<const float> taps, const Rect& part,
                        PlaneStack& result);

/// Derivatives after Horn and Schunck (1981): mean differences along the edges of the cube of 2×2×2 values.
void cube_derivatives(const Plane<float>& first, const Plane<float>& second, const Rect& part, PlaneStack& result);

}  // namespace vvr::fields
