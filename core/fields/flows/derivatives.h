#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <utility>
#include <vector>

#include <hwy/aligned_allocator.h>

#include "core/base/plane.h"
#include "core/fields/flow.h"

namespace vvr::fields {

using AlignedFloats = hwy::AlignedFreeUniquePtr<float[]>;

/// Uninitialized floats, aligned to a cache line.
/// \throws std::bad_alloc, unlike hwy::AllocateAligned
inline AlignedFloats aligned_floats(std::size_t count) {
    AlignedFloats floats = hwy::AllocateAligned<float>(count);
    if (!floats) throw std::bad_alloc();
    return floats;
}

/// Float planes of one size for the solvers. Row j of all planes are adjacent in memory. Each row starts on a cache
/// line, may be read and written for up to two cache lines beyond its end, and has a border of one value on each side.
/// Values are uninitialized.
///
/// The stride is an odd number of cache lines. With a power of two, the same column of all planes would map to the same
/// few cache sets; at 384 columns these conflicts cost a third of the speed.
class PlaneStack {
  public:
    PlaneStack() = default;
    PlaneStack(Size size, int planes) { reset(size, planes); }

    /// Changes the size and keeps the memory: new pages cost the system more time than a solver needs to fill them.
    void reset(Size size, int planes) {
        size_ = size;
        planes_ = planes;
        stride_ = (2 * ((size.width + 2 * line) / (2 * line)) + 1) * line;
        if (count() <= capacity_) return;
        values_ = aligned_floats(count());
        capacity_ = count();
    }

    Size size() const { return size_; }

    /// Stride from a row of a plane to the next, in floats.
    std::ptrdiff_t pitch() const { return stride_ * planes_; }

    /// Row `j` of a plane, -1 <= j <= height; columns run from -1 to the width.
    float* row(int plane, int j) { return values_.get() + offset(plane, j); }
    const float* row(int plane, int j) const { return values_.get() + offset(plane, j); }

    /// Fills the border of the rows `first` to `last` - 1 by replicating edge values; also above the first and below
    /// the last row, if these are in the range.
    void replicate_border(int plane, int first, int last) {
        for (int j = first; j < last; ++j) {
            row(plane, j)[-1] = row(plane, j)[0];
            row(plane, j)[size_.width] = row(plane, j)[size_.width - 1];
        }
        if (first == 0) std::copy_n(row(plane, 0) - 1, size_.width + 2, row(plane, -1) - 1);
        if (last == size_.height) std::copy_n(row(plane, last - 1) - 1, size_.width + 2, row(plane, last) - 1);
    }

    void replicate_border(int plane) { replicate_border(plane, 0, size_.height); }

    void clear(int plane) {
        for (int j = -1; j <= size_.height; ++j) std::fill_n(row(plane, j) - 1, size_.width + 2, 0.F);
    }

    /// A copy of one plane without the border.
    Plane<float> plane(int plane) const {
        auto result = Plane<float>::for_overwrite(size_);
        for (int j = 0; j < size_.height; ++j) std::copy_n(row(plane, j), size_.width, result.row(j).begin());
        return result;
    }

  private:
    static constexpr int line = 16;  // floats per cache line, and per longest vector

    std::size_t count() const {
        return static_cast<std::size_t>(stride_) * static_cast<std::size_t>(planes_) *
                   static_cast<std::size_t>(size_.height + 2) +
               2 * line;
    }

    std::ptrdiff_t offset(int plane, int j) const { return (std::ptrdiff_t{j} + 1) * pitch() + plane * stride_ + line; }

    Size size_;
    int planes_ = 0;
    std::ptrdiff_t stride_ = 0;
    std::size_t capacity_ = 0;
    AlignedFloats values_;
};

/// Planes of the stacks below: derivatives of the grey level along x and y (levels per pixel) and t (levels per frame).
enum DerivativePlane { along_x, along_y, along_t, derivative_planes };

/// The five-point central difference.
inline constexpr std::array five_point{1.F / 12, -8.F / 12, 0.F, 8.F / 12, -1.F / 12};

/// The taps of a Gaussian, 3σ to each side, with sum 1; a single 1 for σ = 0.
std::vector<float> gaussian_taps(double sigma);

/// The taps of smoothing by `taps` and the five-point difference in one, two longer on each side.
std::vector<float> differentiated_taps(std::span<const float> taps);

/// Smooths along rows and columns in float: rounding to 8 bits would cost 6 to 10° of flow direction. Edges are
/// replicated.
Plane<float> smoothed(const Plane<std::uint8_t>& grey, std::span<const float> taps);
Plane<float> smoothed(const Plane<float>& plane, std::span<const float> taps);

/// Derivatives after Barron, Fleet and Beauchemin (1994): smooths frames (already smoothed along x and y) along t with
/// `taps`, then applies (1, -8, 0, 8, -1)/12 along each axis.
/// \param frames as many as `differentiated_taps(taps)` has; the derivatives are those of the middle one, in the part
void barron_derivatives(std::span<const Plane<float>* const> frames, std::span<const float> taps, const PixelBox& part,
                        PlaneStack& result);

/// Derivatives after Horn and Schunck (1981): mean finite differences along the edges of the cube of 2×2×2 values.
void cube_derivatives(const Plane<float>& first, const Plane<float>& second, const PixelBox& part, PlaneStack& result);

}  // namespace vvr::fields
