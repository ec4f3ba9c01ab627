#include "core/fields/planes.h"

#include <cstddef>
#include <span>

#include "core/fields/byte_blur.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/fields/planes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vvr::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<std::uint8_t, 64>;
using One = hn::CappedTag<std::uint8_t, 1>;

template <class D>
HWY_INLINE hn::Vec<D> difference(D, hn::Vec<D> a, hn::Vec<D> b) {
    return hn::Or(hn::SaturatedSub(a, b), hn::SaturatedSub(b, a));
}

template <class D>
HWY_INLINE hn::Vec<D> grey_difference(D d, const std::uint8_t* a, const std::uint8_t* b) {
    return difference(d, hn::LoadU(d, a), hn::LoadU(d, b));
}

template <class D>
HWY_INLINE hn::Vec<D> colour_difference(D d, const std::uint8_t* a, const std::uint8_t* b) {
    hn::Vec<D> a0, a1, a2, b0, b1, b2;
    hn::LoadInterleaved3(d, a, a0, a1, a2);
    hn::LoadInterleaved3(d, b, b0, b1, b2);
    return hn::Max(difference(d, a0, b0), hn::Max(difference(d, a1, b1), difference(d, a2, b2)));
}

void grey(const std::uint8_t* a, const std::uint8_t* b, std::uint8_t* HWY_RESTRICT out, std::size_t count) {
    const Tag d;
    std::size_t i = 0;
    for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) hn::StoreU(grey_difference(d, a + i, b + i), d, out + i);
    for (; i < count; ++i) hn::StoreU(grey_difference(One(), a + i, b + i), One(), out + i);
}

void colour(const std::uint8_t* a, const std::uint8_t* b, std::uint8_t* HWY_RESTRICT out, std::size_t count) {
    const Tag d;
    std::size_t i = 0;
    for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
        hn::StoreU(colour_difference(d, a + 3 * i, b + 3 * i), d, out + i);
    }
    for (; i < count; ++i) {
        std::uint8_t most = 0;
        for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) {
            const auto one = static_cast<std::uint8_t>(a[k] > b[k] ? a[k] - b[k] : b[k] - a[k]);
            if (one > most) most = one;
        }
        out[i] = most;
    }
}

}  // namespace vvr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vvr {

HWY_EXPORT(grey);
HWY_EXPORT(colour);

namespace {

template <class T>
Plane<T> smooth_plane(const Plane<T>& plane, double sigma) {
    if (plane.empty() || sigma <= 0) return plane;
    auto result = Plane<T>::for_overwrite(plane.size());
    const std::size_t count = plane.pixels().size_bytes();
    blur_bytes(plane.size(), sizeof(T), sigma, {reinterpret_cast<const std::uint8_t*>(plane.pixels().data()), count},
               {reinterpret_cast<std::uint8_t*>(result.pixels().data()), count});
    return result;
}

}  // namespace

Planes smoothed(const Plane<std::uint8_t>& grey, const Plane<Bgr>& colour, double sigma) {
    return {smooth_plane(grey, sigma), smooth_plane(colour, sigma)};
}

Plane<std::uint8_t> largest_difference(const Planes& a, const Planes& b) {
    auto result = Plane<std::uint8_t>::for_overwrite(a.grey.size());
    const std::size_t count = result.pixels().size();
    if (a.colour.empty() || b.colour.empty()) {
        HWY_DYNAMIC_DISPATCH(grey)(a.grey.pixels().data(), b.grey.pixels().data(), result.pixels().data(), count);
    } else {
        HWY_DYNAMIC_DISPATCH(colour)
        (a.colour.pixels().front().data(), b.colour.pixels().front().data(), result.pixels().data(), count);
    }
    return result;
}

}  // namespace vvr
#endif
