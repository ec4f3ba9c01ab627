#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/plane.h"

namespace vvr::kernels {

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

}  // namespace vvr::kernels
