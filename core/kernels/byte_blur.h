#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/plane.h"

namespace vvr::kernels {

/// Weights of a Gaussian of `sigma` at -radius ... radius; their sum is 1.
/// \param sigma may be 0 where `radius` is
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

/// Smooths 8-bit values with a Gaussian of `sigma` pixels, cut off at 1.5 sigma and at 1 pixel at least; edges are
/// repeated. Weights are in 1/256. cv::GaussianBlur takes half as long again and rounds otherwise:
/// a grey level more or less in one pixel out of 3000.
/// \param size of the picture, in pixels of `channels` values each
/// \param from, to size.width * size.height * channels values, row by row
void blur_bytes(Size size, int channels, double sigma, std::span<const std::uint8_t> from, std::span<std::uint8_t> to);

}  // namespace vvr::kernels
