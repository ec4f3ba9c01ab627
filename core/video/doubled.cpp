#include "core/video/doubled.h"

#include <algorithm>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/video/doubled.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vvr::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Wide = hn::CappedTag<std::int16_t, 32>;
using Narrow = hn::Rebind<std::uint8_t, Wide>;

/// Three parts of one row and one of the other.
void mix_rows(const std::uint8_t* near, const std::uint8_t* far, std::int16_t* HWY_RESTRICT out, std::size_t count) {
    const Wide wide;
    std::size_t i = 0;
    for (; i + hn::Lanes(wide) <= count; i += hn::Lanes(wide)) {
        const auto a = hn::PromoteTo(wide, hn::LoadU(Narrow(), near + i));
        const auto b = hn::PromoteTo(wide, hn::LoadU(Narrow(), far + i));
        hn::StoreU(hn::Add(hn::Mul(a, hn::Set(wide, 3)), b), wide, out + i);
    }
    for (; i < count; ++i) out[i] = static_cast<std::int16_t>(3 * near[i] + far[i]);
}

/// The same along a row of such mixtures, which has one more value at each end, to both sides.
void widen_row(const std::int16_t* mixed, std::uint8_t* HWY_RESTRICT out, std::size_t count) {
    const Wide wide;
    std::size_t i = 0;
    for (; i + hn::Lanes(wide) <= count; i += hn::Lanes(wide)) {
        const auto middle = hn::Add(hn::Mul(hn::LoadU(wide, mixed + i), hn::Set(wide, 3)), hn::Set(wide, 8));
        const auto left = hn::ShiftRight<4>(hn::Add(middle, hn::LoadU(wide, mixed + i - 1)));
        const auto right = hn::ShiftRight<4>(hn::Add(middle, hn::LoadU(wide, mixed + i + 1)));
        hn::StoreInterleaved2(hn::DemoteTo(Narrow(), left), hn::DemoteTo(Narrow(), right), Narrow(), out + 2 * i);
    }
    for (; i < count; ++i) {
        out[2 * i] = static_cast<std::uint8_t>((3 * mixed[i] + mixed[i - 1] + 8) >> 4);
        out[2 * i + 1] = static_cast<std::uint8_t>((3 * mixed[i] + mixed[i + 1] + 8) >> 4);
    }
}

}  // namespace vvr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vvr {

HWY_EXPORT(mix_rows);
HWY_EXPORT(widen_row);

void double_plane(Size size, const std::uint8_t* from, std::size_t stride, std::span<std::uint8_t> to) {
    const auto width = static_cast<std::size_t>(size.width);
    std::vector<std::int16_t> mixed(width + 2);
    for (int j = 0; j < 2 * size.height; ++j) {
        const int far = std::clamp(j / 2 + (j % 2 == 0 ? -1 : 1), 0, size.height - 1);
        const auto row = [&](int at) { return from + static_cast<std::size_t>(at) * stride; };
        HWY_DYNAMIC_DISPATCH(mix_rows)(row(j / 2), row(far), mixed.data() + 1, width);
        mixed.front() = mixed[1];
        mixed.back() = mixed[width];
        HWY_DYNAMIC_DISPATCH(widen_row)(mixed.data() + 1, to.data() + 2 * width * static_cast<std::size_t>(j), width);
    }
}

}  // namespace vvr
#endif
