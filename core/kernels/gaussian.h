#pragma once

#include <cmath>
#include <vector>

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

}  // namespace vvr::kernels
