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

/// Floats that begin on a cache line. Their values are whatever they are.
/// \throws std::bad_alloc, unlike hwy::AllocateAligned
inline AlignedFloats aligned_floats(std::size_t count) {
    AlignedFloats floats = hwy::AllocateAligned<float>(count);
    if (!floats) throw std::bad_alloc();
    return floats;
}

/// Planes of floats of one size for the solvers: row j of each lies beside row j of the others, each row starts on
/// a cache line and may be read and written up to the next two cache lines beyond its end, and there is a border of
/// one value all round. Values are whatever they are until they are written.
///
/// Rows take an odd number of cache lines. Were it a power of two, the same column of all planes would fall in the
/// same few places of the cache and push each other out; at 384 columns that costs a third of the speed.
class PlaneStack {
  public:
    PlaneStack() = default;
    PlaneStack(Size size, int planes) { reset(size, planes); }

    /// Another size. Memory is kept: the system takes more time to hand out fresh pages than a solver to fill them.
    void reset(Size size, int planes) {
        size_ = size;
        planes_ = planes;
        stride_ = (2 * ((size.width + 2 * line) / (2 * line)) + 1) * line;
        if (count() <= capacity_) return;
        values_ = aligned_floats(count());
        capacity_ = count();
    }

    Size size() const { return size_; }

    /// Floats from a row of a plane to the next.
    std::ptrdiff_t pitch() const { return stride_ * planes_; }

    /// Row `j` of a plane, -1 <= j <= height; its columns run from -1 to the width.
    float* row(int plane, int j) { return values_.get() + offset(plane, j); }
    const float* row(int plane, int j) const { return values_.get() + offset(plane, j); }

    /// Fills the border beside the rows `first` to `last` - 1 with the edges' values, above and below as well where
    /// these rows are the first or the last.
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

    /// A copy of one plane without its border.
    Plane<float> plane(int plane) const {
        auto result = Plane<float>::for_overwrite(size_);
        for (int j = 0; j < size_.height; ++j) std::copy_n(row(plane, j), size_.width, result.row(j).begin());
        return result;
    }

  private:
    static constexpr int line = 16;  // floats in a cache line, and in the longest vector we use

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
