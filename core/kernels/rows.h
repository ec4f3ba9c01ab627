#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/plane.h"

extern "C" {
#include <libavutil/pixfmt.h>
}

namespace vvr::kernels {

/// The chroma factors of the conversion from luma and chroma to BGR, in units of 1/8192.
struct ColourMatrix {
    /// \param full_range whether chroma uses the full range 0 to 255
    ColourMatrix(AVColorSpace space, bool full_range);

    std::int16_t red_of_cr = 0;
    std::int16_t blue_of_cb = 0;
    std::int16_t green_of_cb = 0;
    std::int16_t green_of_cr = 0;

    friend bool operator==(const ColourMatrix&, const ColourMatrix&) = default;
};

/// Converts a row of full-range luma and chroma to BGR in fixed point, with the same result on every machine. All spans
/// have the same length.
void to_bgr(const ColourMatrix& matrix, std::span<const std::uint8_t> luma, std::span<const std::uint8_t> cb,
            std::span<const std::uint8_t> cr, std::span<Bgr> out);

/// Converts a row of luma from 16…235 to 0…255; values outside are clipped.
void to_full_range(std::span<const std::uint8_t> luma, std::span<std::uint8_t> out);

/// out[i] = the difference of a[i] and b[i] in the channel that differs most. All spans have the same length.
void largest_difference(std::span<const Bgr> a, std::span<const Bgr> b, std::span<std::uint8_t> out);

/// The weights of a Gaussian at -radius … radius, with sum 1.
/// \param sigma pixels; may be 0 if `radius` is
inline std::vector<double> gaussian_weights(double sigma, int radius) {
    std::vector<double> weights;
    double sum = 0;
    for (int k = -radius; k <= radius; ++k) {
        weights.push_back(k == 0 ? 1 : std::exp(-k * k / (2 * sigma * sigma)));
        sum += weights.back();
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

/// Gaussian smoothing of 8-bit values, with the kernel cut off at 1.5 σ but at least at 1 pixel. Edges are replicated;
/// weights are multiples of 1/256. cv::GaussianBlur takes 1.5 times as long and rounds differently: by one grey level
/// in one pixel out of 3000.
/// \param size of the picture, in pixels of `channels` values each
/// \param sigma pixels
/// \param from, to size.width * size.height * channels values, row by row
void blur_bytes(Size size, int channels, double sigma, std::span<const std::uint8_t> from, std::span<std::uint8_t> to);

/// out[i] = Σ weights[k] · inputs[k][i] for i < count: a convolution along the row if the inputs are shifted pointers
/// into one row, along columns if they point to rows, along time if they point to frames.
///
/// Reads and writes nothing beyond `count`; `out` must not be one of the inputs.
void weighted_sum(std::span<const float* const> inputs, std::span<const float> weights, float* out, int count);

/// The rows that one Jacobi iteration needs. All start on a cache line and may be read one vector beyond their end.
struct RelaxRows {
    const float* u;
    const float* v;
    const float *m11, *m12, *m22, *c1, *c2;
    float* next_u;
    float* next_v;
    std::ptrdiff_t pitch;  ///< stride from each row to the next, in floats
};

/// One Jacobi iteration for `count` rows of `width` points. With the sums n over the averaging mask [1 2 1; 2 0 2; 1 2
/// 1]: next_u = m11 n_u + m12 n_v + c1, next_v = m12 n_u + m22 n_v + c2.
void relax_rows(const RelaxRows& rows, int width, int count);

/// The coefficients of `relax_rows` from derivatives: M = a (g gᵀ + a)⁻¹ / 12 and c = -(g gᵀ + a)⁻¹ g g_t.
void invert_gradients(const float* gx, const float* gy, const float* gt, float a, float* const m_and_c[5], int width);

/// The coefficients of `relax_rows` from a tensor J and a right-hand side f: M = a (J + a)⁻¹ / 12 and c = (J + a)⁻¹ f.
void invert_tensors(const float* const j_and_f[5], float a, float* const m_and_c[5], int width);

/// The tensor and right-hand side from derivatives: J = g gᵀ, f = -g g_t.
void products(const float* gx, const float* gy, const float* gt, float* const j_and_f[5], int width);

/// The residuals f - J w + a (mean(w) - w) of a row; `above` etc. are rows with a border of one value.
struct ResidualRow {
    const float *u_above, *u, *u_below;
    const float *v_above, *v, *v_below;
    const float* j_and_f[5];
};
void residual_row(const ResidualRow& row, float a, float* r1, float* r2, int width);

/// out[i] = mean of row[2i], row[2i + 1] of both rows.
void mean_of_pairs(const float* upper, const float* lower, float* out, int width);

/// Adds linearly interpolated coarse values to fine[2i] and fine[2i + 1]. The points of `near` are a quarter of the
/// coarse spacing away, those of `far` three quarters. Both have a border of one value.
void add_interpolated(const float* near, const float* far, float* fine, int coarse_width);

/// A row of two frames, of which the second is warped back by the flow. All rows may be read and written one vector
/// beyond their end.
struct WarpRow {
    const Plane<float>& next;  ///< the second frame
    int x;                     ///< column of the row's first point in `next`
    int y;                     ///< row in `next`
    const float* here;         ///< the first frame
    const float *u, *v;        ///< current flow, pixels
    float* mean;               ///< out: mean of the first and the warped second frame
    float* change;             ///< out: difference from the first to the warped second frame
    float* known;              ///< out: 1 where the flow leads into the picture, else 0
    int width;
};
void warp_row(const WarpRow& row);

/// Converts derivatives and difference of a warped row to g and g_t, such that g·w + g_t = 0 has the whole flow w as
/// solution, not only its increment to (u, v). All three are 0 where nothing is known.
/// \param gx, gy in and out: derivatives; aligned, as `gt`
/// \param gt out
void whole_change(const float* u, const float* v, const float* change, const float* known, float* gx, float* gy,
                  float* gt, int width);

}  // namespace vvr::kernels
