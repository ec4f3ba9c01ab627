#pragma once

#include <span>

namespace vvr::kernels {

/// out[i] = Σ weights[k] · inputs[k][i] for i < count. With shifted pointers into one row it is a convolution along the
/// row, with pointers to rows one along columns, with pointers into frames one along time.
///
/// Reads and writes nothing beyond `count`; `out` must not be one of the inputs.
void weighted_sum(std::span<const float* const> inputs, std::span<const float> weights, float* out, int count);

}  // namespace vvr::kernels
