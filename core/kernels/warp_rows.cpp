#include "core/kernels/warp_rows.h"

#include <algorithm>
#include <array>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/warp_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vvr::kernels::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Catmull-Rom interpolation: the weights of four points around a place `t` past the second, 0 <= t <= 1.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void cubic(D d, V t, V& w0, V& w1, V& w2, V& w3) {
    const V half = hn::Set(d, 0.5F);
    const V t2 = hn::Mul(t, t);
    const V t3 = hn::Mul(t2, t);
    w0 = hn::Mul(half, hn::Sub(hn::Add(t2, t2), hn::Add(t, t3)));
    w1 = hn::MulAdd(hn::Set(d, 1.5F), t3, hn::MulAdd(hn::Set(d, -2.5F), t2, hn::Set(d, 1.F)));
    w2 = hn::Mul(half, hn::MulAdd(hn::Set(d, -3.F), t3, hn::MulAdd(hn::Set(d, 4.F), t2, t)));
    w3 = hn::Mul(half, hn::Sub(t3, t2));
}

/// The same for five points and a place `t` past the third, -1 <= t <= 1.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void cubic_of_five(D d, V t, V& w0, V& w1, V& w2, V& w3, V& w4) {
    const V zero = hn::Zero(d);
    const auto left = hn::Lt(t, zero);
    V c0, c1, c2, c3;
    cubic(d, hn::IfThenElse(left, hn::Add(t, hn::Set(d, 1.F)), t), c0, c1, c2, c3);
    w0 = hn::IfThenElse(left, c0, zero);
    w1 = hn::IfThenElse(left, c1, c0);
    w2 = hn::IfThenElse(left, c2, c1);
    w3 = hn::IfThenElse(left, c3, c2);
    w4 = hn::IfThenElse(left, zero, c3);
}

/// One point with any flow; the picture's edges are replicated.
HWY_INLINE void warp_point(const WarpRow& p, int i) {
    const hn::CappedTag<float, 1> d;
    const float x = static_cast<float>(p.x + i) + p.u[i];
    const float y = static_cast<float>(p.y) + p.v[i];
    const int right = p.next.width() - 1;
    const int bottom = p.next.height() - 1;
    // NaN fails every comparison, so it counts as unknown.
    const bool known = x >= 0 && y >= 0 && x <= static_cast<float>(right) && y <= static_cast<float>(bottom);
    float value = p.here[i];
    if (known) {
        const int column = static_cast<int>(x);
        const int row = static_cast<int>(y);
        auto wx0 = hn::Zero(d), wx1 = wx0, wx2 = wx0, wx3 = wx0, wy0 = wx0, wy1 = wx0, wy2 = wx0, wy3 = wx0;
        cubic(d, hn::Set(d, x - static_cast<float>(column)), wx0, wx1, wx2, wx3);
        cubic(d, hn::Set(d, y - static_cast<float>(row)), wy0, wy1, wy2, wy3);
        const std::array<float, 4> across{hn::GetLane(wx0), hn::GetLane(wx1), hn::GetLane(wx2), hn::GetLane(wx3)};
        const std::array<float, 4> down{hn::GetLane(wy0), hn::GetLane(wy1), hn::GetLane(wy2), hn::GetLane(wy3)};
        value = 0;
        for (int k = 0; k < 4; ++k) {
            const float* const line = p.next.row(std::clamp(row - 1 + k, 0, bottom)).data();
            float sum = 0;
            for (int l = 0; l < 4; ++l) {
                sum += across[static_cast<std::size_t>(l)] * line[std::clamp(column - 1 + l, 0, right)];
            }
            value += down[static_cast<std::size_t>(k)] * sum;
        }
    }
    p.mean[i] = (p.here[i] + value) / 2;
    p.change[i] = value - p.here[i];
    p.known[i] = known ? 1.F : 0.F;
}

// Flow varies little between neighbours. So a whole vector of points is moved by one integer shift and at most one
// pixel more or less: all taps are then loads of neighbours. Only where this fails, points are processed one by one.
void warp(const WarpRow& p) {
    const hn::CappedTag<float, 16> d;
    using V = hn::Vec<decltype(d)>;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const V one = hn::Set(d, 1.F);
    const std::ptrdiff_t stride = p.next.width();
    for (int i = 0; i < p.width; i += lanes) {
        const auto whole = [](float value) { return static_cast<int>(value < 0 ? value - 0.5F : value + 0.5F); };
        const bool sane = hn::AllTrue(
            d, hn::Lt(hn::Max(hn::Abs(hn::LoadU(d, p.u + i)), hn::Abs(hn::LoadU(d, p.v + i))), hn::Set(d, 1e4F)));
        const int du = sane ? whole(p.u[i]) : 0;
        const int dv = sane ? whole(p.v[i]) : 0;
        const V tu = hn::Sub(hn::LoadU(d, p.u + i), hn::Set(d, static_cast<float>(du)));
        const V tv = hn::Sub(hn::LoadU(d, p.v + i), hn::Set(d, static_cast<float>(dv)));
        const int x = p.x + i + du;
        const int y = p.y + dv;
        const bool together = sane && i + lanes <= p.width && x >= 2 && x + lanes + 2 <= p.next.width() && y >= 2 &&
                              y + 2 < p.next.height() && hn::AllTrue(d, hn::Le(hn::Max(hn::Abs(tu), hn::Abs(tv)), one));
        if (!together) {
            for (int k = i; k < std::min(i + lanes, p.width); ++k) warp_point(p, k);
            continue;
        }
        V x0, x1, x2, x3, x4, y0, y1, y2, y3, y4;
        cubic_of_five(d, tu, x0, x1, x2, x3, x4);
        cubic_of_five(d, tv, y0, y1, y2, y3, y4);
        const float* const from = p.next.pixels().data() + (y - 2) * stride + x - 2;
        const auto line = [&](const float* q) HWY_ATTR {
            V sum = hn::Mul(x0, hn::LoadU(d, q));
            sum = hn::MulAdd(x1, hn::LoadU(d, q + 1), sum);
            sum = hn::MulAdd(x2, hn::LoadU(d, q + 2), sum);
            sum = hn::MulAdd(x3, hn::LoadU(d, q + 3), sum);
            return hn::MulAdd(x4, hn::LoadU(d, q + 4), sum);
        };
        V value = hn::Mul(y0, line(from));
        value = hn::MulAdd(y1, line(from + stride), value);
        value = hn::MulAdd(y2, line(from + 2 * stride), value);
        value = hn::MulAdd(y3, line(from + 3 * stride), value);
        value = hn::MulAdd(y4, line(from + 4 * stride), value);
        const V before = hn::LoadU(d, p.here + i);
        hn::StoreU(hn::Mul(hn::Set(d, 0.5F), hn::Add(before, value)), d, p.mean + i);
        hn::StoreU(hn::Sub(value, before), d, p.change + i);
        hn::StoreU(one, d, p.known + i);
    }
}

// Makes g_t such that g·w + g_t = 0 has the whole flow w as solution; all three are 0 where nothing is known.
void change_whole(const float* u, const float* v, const float* change, const float* known, float* gx, float* gy,
                  float* gt, int width) {
    const hn::CappedTag<float, 16> d;
    for (int i = 0; i < width; i += static_cast<int>(hn::Lanes(d))) {
        const auto here = hn::LoadU(d, known + i);
        const auto x = hn::Mul(here, hn::Load(d, gx + i));
        const auto y = hn::Mul(here, hn::Load(d, gy + i));
        const auto t = hn::Mul(here, hn::LoadU(d, change + i));
        hn::Store(x, d, gx + i);
        hn::Store(y, d, gy + i);
        hn::Store(hn::NegMulAdd(x, hn::LoadU(d, u + i), hn::NegMulAdd(y, hn::LoadU(d, v + i), t)), d, gt + i);
    }
}

}  // namespace
}  // namespace vvr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vvr::kernels {

HWY_EXPORT(warp);
HWY_EXPORT(change_whole);

void warp_row(const WarpRow& row) {
    HWY_DYNAMIC_DISPATCH(warp)(row);
}

void whole_change(const float* u, const float* v, const float* change, const float* known, float* gx, float* gy,
                  float* gt, int width) {
    HWY_DYNAMIC_DISPATCH(change_whole)(u, v, change, known, gx, gy, gt, width);
}

}  // namespace vvr::kernels
#endif
