#include "core/kernels/weighted_sum.h"

#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/weighted_sum.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vvr::kernels::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

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

HWY_EXPORT(sum);

void weighted_sum(std::span<const float* const> inputs, std::span<const float> weights, float* out, int count) {
    HWY_DYNAMIC_DISPATCH(sum)(inputs.data(), weights.data(), weights.size(), out, count);
}

}  // namespace vvr::kernels
#endif
