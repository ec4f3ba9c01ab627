#include "tests/bench/roofline.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>

#include <hwy/aligned_allocator.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/roofline.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vvr::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<float, 16>;
using Vec = hn::Vec<Tag>;

// Ten sums, all different, that don't wait for each other keep two units busy that take four cycles.
double multiply_and_add(int times) {
    const Tag d;
    const Vec by = hn::Set(d, 1.0000001F);
    Vec a = hn::Iota(d, 1.F), b = hn::Add(a, a), c = hn::Add(a, b), e = hn::Add(b, b), f = hn::Add(c, b),
        g = hn::Add(c, c);
    Vec h = hn::Add(e, c), i = hn::Add(e, e), j = hn::Add(f, e), k = hn::Add(f, f);
    for (int n = 0; n < times; ++n) {
        a = hn::MulAdd(a, by, by);
        b = hn::MulAdd(b, by, by);
        c = hn::MulAdd(c, by, by);
        e = hn::MulAdd(e, by, by);
        f = hn::MulAdd(f, by, by);
        g = hn::MulAdd(g, by, by);
        h = hn::MulAdd(h, by, by);
        i = hn::MulAdd(i, by, by);
        j = hn::MulAdd(j, by, by);
        k = hn::MulAdd(k, by, by);
    }
    const Vec sum =
        hn::Add(hn::Add(hn::Add(a, b), hn::Add(c, e)), hn::Add(hn::Add(hn::Add(f, g), hn::Add(h, i)), hn::Add(j, k)));
    volatile float keep = hn::GetLane(sum);
    static_cast<void>(keep);
    return 2.0 * 10 * static_cast<double>(hn::Lanes(d)) * times;
}

void triad(float* HWY_RESTRICT a, const float* HWY_RESTRICT b, const float* HWY_RESTRICT c, std::size_t count) {
    const Tag d;
    const Vec by = hn::Set(d, 0.5F);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        hn::Store(hn::MulAdd(by, hn::Load(d, c + i), hn::Load(d, b + i)), d, a + i);
    }
}

}  // namespace vvr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vvr::bench {

HWY_EXPORT(multiply_and_add);
HWY_EXPORT(triad);

namespace {

// The best of some: what the machine can do is wanted, not what it did while something else ran.
template <class Work>
double best_rate(Work work) {
    double best = 0;
    for (int run = 0; run < 30; ++run) {
        const auto begin = std::chrono::steady_clock::now();
        const double done = work();
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
        best = std::max(best, done / took.count());
    }
    return best;
}

}  // namespace

double peak_flops() {
    return best_rate([] { return HWY_DYNAMIC_DISPATCH(multiply_and_add)(100'000); });
}

double triad_bytes(std::size_t bytes) {
    constexpr std::size_t step = 64;  // floats; so that each array is a whole number of vectors
    const std::size_t count = bytes / sizeof(float) / 3 / step * step;
    std::array<hwy::AlignedFreeUniquePtr<float[]>, 3> arrays;
    for (auto& array : arrays) {
        array = hwy::AllocateAligned<float>(count);
        std::fill_n(array.get(), count, 1.F);
    }
    const std::size_t times = std::max<std::size_t>(1, 3'000'000 / count);
    return best_rate([&] {
        for (std::size_t n = 0; n < times; ++n) {
            HWY_DYNAMIC_DISPATCH(triad)(arrays[0].get(), arrays[1].get(), arrays[2].get(), count);
        }
        return static_cast<double>(3 * sizeof(float) * count * times);
    });
}

}  // namespace vvr::bench
#endif
