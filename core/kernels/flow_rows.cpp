#include <algorithm>
#include <array>
#include <cstddef>

#include "core/kernels/rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/flow_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vvr::kernels::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<float, 16>;
using Vec = hn::Vec<Tag>;

// The mask's sum over one row: left + 2 · here + right.
HWY_INLINE Vec across(Tag d, const float* p, Vec here) {
    return hn::MulAdd(hn::Set(d, 2.F), here, hn::Add(hn::LoadU(d, p - 1), hn::LoadU(d, p + 1)));
}

// The mask's sum over three rows' sums, without the centre.
HWY_INLINE Vec mask(Tag d, Vec above, Vec row, Vec below, Vec here) {
    return hn::NegMulAdd(hn::Set(d, 4.F), here, hn::MulAdd(hn::Set(d, 2.F), row, hn::Add(above, below)));
}

/// Rotates a vector's lanes by one, up and down. `first` and `last` select the lanes that come from the adjacent
/// vector.
struct Turns {
    using Table = hn::RebindToSigned<Tag>;
    using Indices = decltype(hn::IndicesFromVec(Tag(), hn::Zero(Table())));

    Indices up, down;
    hn::Mask<Tag> first, last;
};

HWY_INLINE Turns turns(Tag d) {
    const Turns::Table ints;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const auto by = [&](int step) HWY_ATTR {
        return hn::IndicesFromVec(d, hn::And(hn::Iota(ints, step), hn::Set(ints, lanes - 1)));
    };
    return {by(lanes - 1), by(1), hn::FirstN(d, 1), hn::Not(hn::FirstN(d, hn::Lanes(d) - 1))};
}

/// Partial sums of the averaging mask for one vector of a row. The column sums, above + 2 · here + below, are used by
/// the neighbours in the row too.
struct Sums {
    Vec without_right;  ///< the mask's sums without the share of the vector to the right
    Vec up, down;       ///< the column sums, rotated by one lane each way
};

HWY_INLINE Sums add_up(Tag d, const Turns& turn, const Sums& left, Vec above, Vec here, Vec below) {
    const Vec sum = hn::MulAdd(hn::Set(d, 2.F), here, hn::Add(above, below));
    const Vec up = hn::TableLookupLanes(sum, turn.up);
    const Vec from_left = hn::IfThenElse(turn.first, left.up, up);
    return {hn::NegMulAdd(hn::Set(d, 4.F), here, hn::MulAdd(hn::Set(d, 2.F), sum, from_left)), up,
            hn::TableLookupLanes(sum, turn.down)};
}

/// Computes a row of one flow component and, with `both`, the next row too: they share two of their four input rows.
template <bool both>
struct Walk {
    Sums upper, lower;     ///< at the current vector
    Vec n_upper, n_lower;  ///< the mask's sums of the previous vector

    HWY_INLINE void step(Tag d, const Turns& turn, const float* p, std::ptrdiff_t pitch) {
        const Vec here = hn::Load(d, p);
        const Vec below = hn::Load(d, p + pitch);
        const Sums right = add_up(d, turn, upper, hn::Load(d, p - pitch), here, below);
        n_upper = hn::Add(upper.without_right, hn::IfThenElse(turn.last, right.down, upper.down));
        upper = right;
        if constexpr (both) {
            const Sums lower_right = add_up(d, turn, lower, here, below, hn::Load(d, p + 2 * pitch));
            n_lower = hn::Add(lower.without_right, hn::IfThenElse(turn.last, lower_right.down, lower.down));
            lower = lower_right;
        }
    }

    HWY_INLINE void begin(Tag d, const Turns& turn, const float* p, std::ptrdiff_t pitch) {
        const Vec none = hn::Zero(d);
        upper = lower = {none, none, none};
        step(d, turn, p - hn::Lanes(d), pitch);
        step(d, turn, p, pitch);
    }
};

HWY_INLINE void store(Tag d, const RelaxRows& p, std::ptrdiff_t at, Vec n_u, Vec n_v) {
    const Vec m12 = hn::Load(d, p.m12 + at);
    hn::Store(hn::MulAdd(hn::Load(d, p.m11 + at), n_u, hn::MulAdd(m12, n_v, hn::Load(d, p.c1 + at))), d, p.next_u + at);
    hn::Store(hn::MulAdd(hn::Load(d, p.m22 + at), n_v, hn::MulAdd(m12, n_u, hn::Load(d, p.c2 + at))), d, p.next_v + at);
}

// All loads are aligned: nine per point.
template <bool both>
HWY_INLINE void relax_along(Tag d, const Turns& turn, const RelaxRows& p, std::ptrdiff_t first, int width) {
    Walk<both> u, v;
    u.begin(d, turn, p.u + first, p.pitch);
    v.begin(d, turn, p.v + first, p.pitch);
    const int lanes = static_cast<int>(hn::Lanes(d));
    for (int x = 0; x < width; x += lanes) {
        const std::ptrdiff_t at = first + x;
        u.step(d, turn, p.u + at + lanes, p.pitch);
        v.step(d, turn, p.v + at + lanes, p.pitch);
        store(d, p, at, u.n_upper, v.n_upper);
        if constexpr (both) store(d, p, at + p.pitch, u.n_lower, v.n_lower);
    }
}

void relax(const RelaxRows& rows, int width, int count) {
    const Tag d;
    const RelaxRows p = rows;  // a copy, so that the compiler knows that no store changes it
    const Turns turn = turns(d);
    int j = 0;
    for (; j + 2 <= count; j += 2) relax_along<true>(d, turn, p, j * p.pitch, width);
    if (j < count) relax_along<false>(d, turn, p, j * p.pitch, width);
}

// g gᵀ has rank one, so the inverse needs no determinant, which would lose precision: (g gᵀ + a)⁻¹ g = g / (a + |g|²).
void invert_rank_one(const float* gx, const float* gy, const float* gt, float a, float* const out[5], int width) {
    const Tag d;
    const Vec va = hn::Set(d, a);
    const Vec twelfth = hn::Set(d, 1.F / 12);
    for (int x = 0; x < width; x += static_cast<int>(hn::Lanes(d))) {
        const Vec dx = hn::Load(d, gx + x);
        const Vec dy = hn::Load(d, gy + x);
        const Vec yy = hn::MulAdd(dy, dy, va);
        const Vec scale = hn::Div(hn::Set(d, 1.F), hn::MulAdd(dx, dx, yy));
        const Vec mean = hn::Mul(scale, twelfth);
        const Vec change = hn::Mul(hn::Load(d, gt + x), scale);
        hn::Store(hn::Mul(yy, mean), d, out[0] + x);
        hn::Store(hn::Neg(hn::Mul(hn::Mul(dx, dy), mean)), d, out[1] + x);
        hn::Store(hn::Mul(hn::MulAdd(dx, dx, va), mean), d, out[2] + x);
        hn::Store(hn::Neg(hn::Mul(dx, change)), d, out[3] + x);
        hn::Store(hn::Neg(hn::Mul(dy, change)), d, out[4] + x);
    }
}

void invert(const float* const in[5], float a, float* const out[5], int width) {
    const Tag d;
    const Vec va = hn::Set(d, a);
    const Vec scale = hn::Set(d, a / 12);
    for (int x = 0; x < width; x += static_cast<int>(hn::Lanes(d))) {
        const Vec j11 = hn::Load(d, in[0] + x);
        const Vec j12 = hn::Load(d, in[1] + x);
        const Vec j22 = hn::Load(d, in[2] + x);
        const Vec f1 = hn::Load(d, in[3] + x);
        const Vec f2 = hn::Load(d, in[4] + x);
        // J is a mean of g gᵀ, so its exact determinant is not negative; rounding may make it so.
        const Vec own = hn::Max(hn::NegMulAdd(j12, j12, hn::Mul(j11, j22)), hn::Zero(d));
        const Vec det = hn::MulAdd(va, hn::Add(hn::Add(j11, j22), va), own);
        const Vec inverse = hn::Div(hn::Set(d, 1.F), det);
        const Vec i11 = hn::Mul(hn::Add(j22, va), inverse);
        const Vec i12 = hn::Neg(hn::Mul(j12, inverse));
        const Vec i22 = hn::Mul(hn::Add(j11, va), inverse);
        hn::Store(hn::Mul(i11, scale), d, out[0] + x);
        hn::Store(hn::Mul(i12, scale), d, out[1] + x);
        hn::Store(hn::Mul(i22, scale), d, out[2] + x);
        hn::Store(hn::MulAdd(i11, f1, hn::Mul(i12, f2)), d, out[3] + x);
        hn::Store(hn::MulAdd(i12, f1, hn::Mul(i22, f2)), d, out[4] + x);
    }
}

void multiply(const float* gx, const float* gy, const float* gt, float* const out[5], int width) {
    const Tag d;
    for (int x = 0; x < width; x += static_cast<int>(hn::Lanes(d))) {
        const Vec dx = hn::Load(d, gx + x);
        const Vec dy = hn::Load(d, gy + x);
        const Vec dt = hn::Neg(hn::Load(d, gt + x));
        hn::Store(hn::Mul(dx, dx), d, out[0] + x);
        hn::Store(hn::Mul(dx, dy), d, out[1] + x);
        hn::Store(hn::Mul(dy, dy), d, out[2] + x);
        hn::Store(hn::Mul(dx, dt), d, out[3] + x);
        hn::Store(hn::Mul(dy, dt), d, out[4] + x);
    }
}

HWY_INLINE Vec laplacian(Tag d, const float* above, const float* row, const float* below, Vec here) {
    const Vec sums =
        mask(d, across(d, above, hn::Load(d, above)), across(d, row, here), across(d, below, hn::Load(d, below)), here);
    return hn::MulSub(sums, hn::Set(d, 1.F / 12), here);
}

void residual(const ResidualRow& p, float a, float* r1, float* r2, int width) {
    const Tag d;
    const Vec va = hn::Set(d, a);
    for (int x = 0; x < width; x += static_cast<int>(hn::Lanes(d))) {
        const Vec u = hn::Load(d, p.u + x);
        const Vec v = hn::Load(d, p.v + x);
        const Vec j12 = hn::Load(d, p.j_and_f[1] + x);
        const Vec f1 =
            hn::MulAdd(va, laplacian(d, p.u_above + x, p.u + x, p.u_below + x, u), hn::Load(d, p.j_and_f[3] + x));
        const Vec f2 =
            hn::MulAdd(va, laplacian(d, p.v_above + x, p.v + x, p.v_below + x, v), hn::Load(d, p.j_and_f[4] + x));
        hn::Store(hn::NegMulAdd(hn::Load(d, p.j_and_f[0] + x), u, hn::NegMulAdd(j12, v, f1)), d, r1 + x);
        hn::Store(hn::NegMulAdd(j12, u, hn::NegMulAdd(hn::Load(d, p.j_and_f[2] + x), v, f2)), d, r2 + x);
    }
}

void pairs(const float* upper, const float* lower, float* out, int width) {
    const Tag d;
    for (int x = 0; x < width; x += static_cast<int>(hn::Lanes(d))) {
        Vec a, b, c, e;
        hn::LoadInterleaved2(d, upper + 2 * x, a, b);
        hn::LoadInterleaved2(d, lower + 2 * x, c, e);
        hn::Store(hn::Mul(hn::Add(hn::Add(a, b), hn::Add(c, e)), hn::Set(d, 0.25F)), d, out + x);
    }
}

void interpolate(const float* near, const float* far, float* fine, int width) {
    const Tag d;
    const Vec most = hn::Set(d, 0.75F);
    const Vec rest = hn::Set(d, 0.25F);
    const auto down = [&](int x) HWY_ATTR {
        return hn::MulAdd(most, hn::LoadU(d, near + x), hn::Mul(rest, hn::LoadU(d, far + x)));
    };
    for (int x = 0; x < width; x += static_cast<int>(hn::Lanes(d))) {
        const Vec here = hn::Mul(most, down(x));
        Vec even, odd;
        hn::LoadInterleaved2(d, fine + 2 * x, even, odd);
        even = hn::Add(even, hn::MulAdd(rest, down(x - 1), here));
        odd = hn::Add(odd, hn::MulAdd(rest, down(x + 1), here));
        hn::StoreInterleaved2(even, odd, d, fine + 2 * x);
    }
}

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

HWY_EXPORT(relax);
HWY_EXPORT(invert_rank_one);
HWY_EXPORT(invert);
HWY_EXPORT(multiply);
HWY_EXPORT(residual);
HWY_EXPORT(pairs);
HWY_EXPORT(interpolate);
HWY_EXPORT(warp);
HWY_EXPORT(change_whole);

void relax_rows(const RelaxRows& rows, int width, int count) {
    HWY_DYNAMIC_DISPATCH(relax)(rows, width, count);
}

void invert_gradients(const float* gx, const float* gy, const float* gt, float a, float* const m_and_c[5], int width) {
    HWY_DYNAMIC_DISPATCH(invert_rank_one)(gx, gy, gt, a, m_and_c, width);
}

void invert_tensors(const float* const j_and_f[5], float a, float* const m_and_c[5], int width) {
    HWY_DYNAMIC_DISPATCH(invert)(j_and_f, a, m_and_c, width);
}

void products(const float* gx, const float* gy, const float* gt, float* const j_and_f[5], int width) {
    HWY_DYNAMIC_DISPATCH(multiply)(gx, gy, gt, j_and_f, width);
}

void residual_row(const ResidualRow& row, float a, float* r1, float* r2, int width) {
    HWY_DYNAMIC_DISPATCH(residual)(row, a, r1, r2, width);
}

void mean_of_pairs(const float* upper, const float* lower, float* out, int width) {
    HWY_DYNAMIC_DISPATCH(pairs)(upper, lower, out, width);
}

void add_interpolated(const float* near, const float* far, float* fine, int coarse_width) {
    HWY_DYNAMIC_DISPATCH(interpolate)(near, far, fine, coarse_width);
}

void warp_row(const WarpRow& row) {
    HWY_DYNAMIC_DISPATCH(warp)(row);
}

void whole_change(const float* u, const float* v, const float* change, const float* known, float* gx, float* gy,
                  float* gt, int width) {
    HWY_DYNAMIC_DISPATCH(change_whole)(u, v, change, known, gx, gy, gt, width);
}

}  // namespace vvr::kernels
#endif
