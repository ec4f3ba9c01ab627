#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "core/kernels/rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/colour_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vvr::kernels::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Sixteen bits suffice: chroma times a factor has units of 1/64 level.
void bgr_row(const ColourMatrix& matrix, const std::uint8_t* luma, const std::uint8_t* cb, const std::uint8_t* cr,
             std::uint8_t* out, std::size_t pixels) {
    const hn::CappedTag<std::int16_t, 32> wide;
    const hn::Rebind<std::uint8_t, decltype(wide)> narrow;
    const std::size_t lanes = hn::Lanes(wide);
    const auto half = hn::Set(wide, 1 << 5);
    const auto middle = hn::Set(wide, 128);
    const auto load = [&](const std::uint8_t* from) { return hn::PromoteTo(wide, hn::LoadU(narrow, from)); };
    const auto blue_of_cb = hn::Set(wide, matrix.blue_of_cb);
    const auto green_of_cb = hn::Set(wide, matrix.green_of_cb);
    const auto green_of_cr = hn::Set(wide, matrix.green_of_cr);
    const auto red_of_cr = hn::Set(wide, matrix.red_of_cr);
    for (std::size_t i = 0; i < pixels; i += lanes) {
        const auto base = hn::Add(hn::ShiftLeft<6>(load(luma + i)), half);
        const auto b = hn::ShiftLeft<8>(hn::Sub(load(cb + i), middle));
        const auto r = hn::ShiftLeft<8>(hn::Sub(load(cr + i), middle));
        const auto byte = [&](auto more) {
            return hn::DemoteTo(narrow, hn::ShiftRight<6>(hn::SaturatedAdd(base, more)));
        };
        const auto blue = byte(hn::MulFixedPoint15(b, blue_of_cb));
        const auto green = byte(hn::Add(hn::MulFixedPoint15(b, green_of_cb), hn::MulFixedPoint15(r, green_of_cr)));
        const auto red = byte(hn::MulFixedPoint15(r, red_of_cr));
        hn::StoreInterleaved3(blue, green, red, narrow, out + 3 * i);
    }
}

// The scale 255/219 minus 1, in units of 1/32768, rounded.
constexpr std::int16_t more = 5387;

void full_range_row(const std::uint8_t* luma, std::uint8_t* out, std::size_t pixels) {
    const hn::CappedTag<std::int16_t, 32> wide;
    const hn::Rebind<std::uint8_t, decltype(wide)> narrow;
    const std::size_t lanes = hn::Lanes(wide);
    const auto black = hn::Set(narrow, 16);
    const auto factor = hn::Set(wide, more);
    std::size_t i = 0;
    for (; i + lanes <= pixels; i += lanes) {
        const auto value = hn::PromoteTo(wide, hn::SaturatedSub(hn::LoadU(narrow, luma + i), black));
        hn::StoreU(hn::DemoteTo(narrow, hn::Add(value, hn::MulFixedPoint15(value, factor))), narrow, out + i);
    }
    for (; i < pixels; ++i) {
        const int value = luma[i] < 16 ? 0 : luma[i] - 16;
        const int stretched = value + ((value * more + (1 << 14)) >> 15);
        out[i] = static_cast<std::uint8_t>(stretched > 255 ? 255 : stretched);
    }
}

/// The values of `a` and `b` are interleaved in threes.
void difference_row(const std::uint8_t* a, const std::uint8_t* b, std::uint8_t* out, std::size_t pixels) {
    const hn::CappedTag<std::uint8_t, 32> bytes;
    const std::size_t lanes = hn::Lanes(bytes);
    const auto apart = [](auto x, auto y) { return hn::Or(hn::SaturatedSub(x, y), hn::SaturatedSub(y, x)); };
    std::size_t i = 0;
    for (; i + lanes <= pixels; i += lanes) {
        auto a0 = hn::Zero(bytes), a1 = a0, a2 = a0, b0 = a0, b1 = a0, b2 = a0;
        hn::LoadInterleaved3(bytes, a + 3 * i, a0, a1, a2);
        hn::LoadInterleaved3(bytes, b + 3 * i, b0, b1, b2);
        hn::StoreU(hn::Max(hn::Max(apart(a0, b0), apart(a1, b1)), apart(a2, b2)), bytes, out + i);
    }
    for (; i < pixels; ++i) {
        int most = 0;
        for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) most = std::max(most, a[k] < b[k] ? b[k] - a[k] : a[k] - b[k]);
        out[i] = static_cast<std::uint8_t>(most);
    }
}

}  // namespace
}  // namespace vvr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vvr::kernels {

HWY_EXPORT(bgr_row);
HWY_EXPORT(difference_row);
HWY_EXPORT(full_range_row);

namespace {

/// Fixed point with units of 4/32768, because factors reach 2.2.
std::int16_t fixed(double value) {
    return static_cast<std::int16_t>(std::lround(value / 4 * 32768));
}

}  // namespace

ColourMatrix::ColourMatrix(AVColorSpace space, bool full_range) {
    double red = 0.299;
    double blue = 0.114;
    if (space == AVCOL_SPC_BT709) std::tie(red, blue) = std::pair(0.2126, 0.0722);
    if (space == AVCOL_SPC_BT2020_NCL || space == AVCOL_SPC_BT2020_CL) std::tie(red, blue) = std::pair(0.2627, 0.0593);
    const double green = 1 - red - blue;
    const double stretch = full_range ? 1 : 255.0 / 224;
    red_of_cr = fixed(2 * (1 - red) * stretch);
    blue_of_cb = fixed(2 * (1 - blue) * stretch);
    green_of_cb = fixed(-2 * (1 - blue) * blue / green * stretch);
    green_of_cr = fixed(-2 * (1 - red) * red / green * stretch);
}

void to_bgr(const ColourMatrix& matrix, std::span<const std::uint8_t> luma, std::span<const std::uint8_t> cb,
            std::span<const std::uint8_t> cr, std::span<Bgr> out) {
    constexpr std::size_t lanes = 32;  // pixels in the longest vector in use
    const std::size_t whole = out.size() / lanes * lanes;
    const auto bgr = HWY_DYNAMIC_DISPATCH(bgr_row);
    if (whole > 0) bgr(matrix, luma.data(), cb.data(), cr.data(), out.front().data(), whole);
    const std::size_t rest = out.size() - whole;
    if (rest == 0) return;
    std::array<std::uint8_t, lanes> y{}, u{}, v{};
    std::array<std::uint8_t, 3 * lanes> pixels{};
    std::ranges::copy(luma.subspan(whole), y.begin());
    std::ranges::copy(cb.subspan(whole), u.begin());
    std::ranges::copy(cr.subspan(whole), v.begin());
    bgr(matrix, y.data(), u.data(), v.data(), pixels.data(), lanes);
    for (std::size_t i = 0; i < rest; ++i) out[whole + i] = {pixels[3 * i], pixels[3 * i + 1], pixels[3 * i + 2]};
}

void to_full_range(std::span<const std::uint8_t> luma, std::span<std::uint8_t> out) {
    HWY_DYNAMIC_DISPATCH(full_range_row)(luma.data(), out.data(), luma.size());
}

void largest_difference(std::span<const Bgr> a, std::span<const Bgr> b, std::span<std::uint8_t> out) {
    if (out.empty()) return;
    HWY_DYNAMIC_DISPATCH(difference_row)(a.front().data(), b.front().data(), out.data(), out.size());
}

}  // namespace vvr::kernels
#endif
