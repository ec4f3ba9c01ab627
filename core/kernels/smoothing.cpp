#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/kernels/rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/smoothing.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vvr::kernels::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Wide = hn::CappedTag<std::uint16_t, 32>;
using Narrow = hn::Rebind<std::uint8_t, Wide>;

/// The vertical pass: weighted sums of bytes, in units of 1/256.
void down(const std::uint8_t* const* rows, const std::uint16_t* taps, std::size_t terms,
          std::uint16_t* HWY_RESTRICT out, std::size_t count) {
    const Wide wide;
    std::size_t i = 0;
    for (; i + hn::Lanes(wide) <= count; i += hn::Lanes(wide)) {
        auto sum = hn::Zero(wide);
        for (std::size_t k = 0; k < terms; ++k) {
            const auto value = hn::PromoteTo(wide, hn::LoadU(Narrow(), rows[k] + i));
            sum = hn::Add(sum, hn::Mul(value, hn::Set(wide, taps[k])));
        }
        hn::StoreU(sum, wide, out + i);
    }
    for (; i < count; ++i) {
        unsigned sum = 0;
        for (std::size_t k = 0; k < terms; ++k) sum += static_cast<unsigned>(rows[k][i]) * taps[k];
        out[i] = static_cast<std::uint16_t>(sum);
    }
}

/// The horizontal pass over such sums, `step` values apart, rounded to bytes. Each product loses half of 1/256 on
/// average.
void along(const std::uint16_t* in, std::size_t step, const std::uint16_t* taps, std::size_t terms,
           std::uint8_t* HWY_RESTRICT out, std::size_t count) {
    const Wide wide;
    const hn::RebindToSigned<Wide> positive;
    const auto rounding = static_cast<std::uint16_t>(128 + terms / 2);
    std::size_t i = 0;
    for (; i + hn::Lanes(wide) <= count; i += hn::Lanes(wide)) {
        auto sum = hn::Set(wide, rounding);
        for (std::size_t k = 0; k < terms; ++k) {
            const auto tap = hn::Set(wide, static_cast<std::uint16_t>(taps[k] << 8));
            sum = hn::Add(sum, hn::MulHigh(hn::LoadU(wide, in + i + k * step), tap));
        }
        hn::StoreU(hn::DemoteTo(Narrow(), hn::BitCast(positive, hn::ShiftRight<8>(sum))), Narrow(), out + i);
    }
    for (; i < count; ++i) {
        unsigned sum = rounding;
        for (std::size_t k = 0; k < terms; ++k) sum += static_cast<unsigned>(in[i + k * step]) * taps[k] >> 8;
        out[i] = static_cast<std::uint8_t>(sum >> 8);
    }
}

void sum(const float* const* inputs, const float* weights, std::size_t terms, float* HWY_RESTRICT out, int count) {
    const hn::CappedTag<float, 16> d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    int i = 0;
    for (; i + lanes <= count; i += lanes) {
        auto total = hn::Mul(hn::Set(d, weights[0]), hn::LoadU(d, inputs[0] + i));
        for (std::size_t k = 1; k < terms; ++k) {
            total = hn::MulAdd(hn::Set(d, weights[k]), hn::LoadU(d, inputs[k] + i), total);
        }
        hn::StoreU(total, d, out + i);
    }
    // The rest, one by one with the same operations in the same order: a value must not depend on its position in the
    // vector.
    const hn::CappedTag<float, 1> one;
    for (; i < count; ++i) {
        auto total = hn::Mul(hn::Set(one, weights[0]), hn::LoadU(one, inputs[0] + i));
        for (std::size_t k = 1; k < terms; ++k) {
            total = hn::MulAdd(hn::Set(one, weights[k]), hn::LoadU(one, inputs[k] + i), total);
        }
        hn::StoreU(total, one, out + i);
    }
}

}  // namespace
}  // namespace vvr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vvr::kernels {

HWY_EXPORT(down);
HWY_EXPORT(along);
HWY_EXPORT(sum);

namespace {

/// Weights in units of 1/256, with sum 1.
std::vector<std::uint16_t> taps_of(double sigma) {
    const int radius = std::max(1, static_cast<int>(std::lround(1.5 * sigma)));
    std::vector<std::uint16_t> taps;
    int rest = 256;
    for (const double weight : gaussian_weights(sigma, radius)) {
        taps.push_back(static_cast<std::uint16_t>(std::lround(256 * weight)));
        rest -= taps.back();
    }
    auto& middle = taps[static_cast<std::size_t>(radius)];
    middle = static_cast<std::uint16_t>(middle + rest);
    return taps;
}

}  // namespace

void blur_bytes(Size size, int channels, double sigma, std::span<const std::uint8_t> from, std::span<std::uint8_t> to) {
    const std::vector<std::uint16_t> taps = taps_of(sigma);
    const int radius = static_cast<int>(taps.size() / 2);
    const auto step = static_cast<std::size_t>(channels);
    const std::size_t stride = step * static_cast<std::size_t>(size.width);
    const std::size_t edge = step * static_cast<std::size_t>(radius);
    std::vector<const std::uint8_t*> rows(taps.size());
    std::vector<std::uint16_t> sums(stride + 2 * edge);
    for (int j = 0; j < size.height; ++j) {
        for (std::size_t k = 0; k < taps.size(); ++k) {
            const int row = std::clamp(j + static_cast<int>(k) - radius, 0, size.height - 1);
            rows[k] = from.data() + static_cast<std::size_t>(row) * stride;
        }
        HWY_DYNAMIC_DISPATCH(down)(rows.data(), taps.data(), taps.size(), sums.data() + edge, stride);
        for (std::size_t i = edge; i-- > 0;) sums[i] = sums[i + step];
        for (std::size_t i = stride + edge; i < sums.size(); ++i) sums[i] = sums[i - step];
        std::uint8_t* const out = to.data() + static_cast<std::size_t>(j) * stride;
        HWY_DYNAMIC_DISPATCH(along)(sums.data(), step, taps.data(), taps.size(), out, stride);
    }
}

void weighted_sum(std::span<const float* const> inputs, std::span<const float> weights, float* out, int count) {
    HWY_DYNAMIC_DISPATCH(sum)(inputs.data(), weights.data(), weights.size(), out, count);
}

}  // namespace vvr::kernels
#endif
