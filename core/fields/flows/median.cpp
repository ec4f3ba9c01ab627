#include "core/fields/flows/median.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/fields/flows/median.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vvr::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<float, 16>;
using Vec = hn::Vec<Tag>;

HWY_INLINE void order(Vec& a, Vec& b) {
    const Vec low = hn::Min(a, b);
    b = hn::Max(a, b);
    a = low;
}

HWY_INLINE void sort(Vec& a, Vec& b, Vec& c) {
    order(a, b);
    order(b, c);
    order(a, b);
}

/// Three rows with a border of one value on the left and a vector's length on the right.
void median_row(const float* above, const float* row, const float* below, float* out, int width) {
    const Tag d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    for (int x = 0; x < width; x += lanes) {
        // Sort each column; the median of nine is that of the largest small, the middle of the middle and the
        // smallest large one.
        Vec low0 = hn::LoadU(d, above + x), middle0 = hn::LoadU(d, row + x), high0 = hn::LoadU(d, below + x);
        Vec low1 = hn::LoadU(d, above + x + 1), middle1 = hn::LoadU(d, row + x + 1),
            high1 = hn::LoadU(d, below + x + 1);
        Vec low2 = hn::LoadU(d, above + x + 2), middle2 = hn::LoadU(d, row + x + 2),
            high2 = hn::LoadU(d, below + x + 2);
        sort(low0, middle0, high0);
        sort(low1, middle1, high1);
        sort(low2, middle2, high2);
        Vec a = hn::Max(hn::Max(low0, low1), low2);
        order(middle0, middle1);
        Vec b = hn::Max(middle0, hn::Min(middle1, middle2));
        const Vec c = hn::Min(hn::Min(high0, high1), high2);
        order(a, b);
        b = hn::Max(a, hn::Min(b, c));
        hn::StoreU(b, d, out + x);
    }
}

}  // namespace vvr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vvr {

HWY_EXPORT(median_row);

Plane<float> median_of_nine(const Plane<float>& plane) {
    constexpr int lanes = 16;  // of the longest vector that is used
    const auto width = static_cast<std::size_t>(plane.width());
    const std::size_t room = width + 2 * lanes;
    std::vector<float> wide(3 * room);
    const auto widen = [&](int j) {
        float* const to = wide.data() + static_cast<std::size_t>((j + 3) % 3) * room;
        const std::span<const float> from = plane.row(std::clamp(j, 0, plane.height() - 1));
        to[0] = from.front();
        std::ranges::copy(from, to + 1);
        to[width + 1] = from.back();
        return to;
    };
    auto result = Plane<float>::for_overwrite(plane.size());
    std::vector<float> out(room);
    const float* above = widen(-1);
    const float* row = widen(0);
    for (int j = 0; j < plane.height(); ++j) {
        const float* const below = widen(j + 1);
        HWY_DYNAMIC_DISPATCH(median_row)(above, row, below, out.data(), plane.width());
        std::copy_n(out.begin(), width, result.row(j).begin());
        above = row;
        row = below;
    }
    return result;
}

}  // namespace vvr
#endif
