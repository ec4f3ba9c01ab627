#pragma once

#include <span>

namespace vvr::kernels {

/// out[i] = Σ weights[k] · inputs[k][i] for i < count: a convolution along the row if the inputs are shifted pointers
/// into one row, along columns if they point to rows, along time if they point to frames.
///
/// Reads and writes nothing beyond `count`; `out` must not be one of the inputs.
void weighted_sum(std::span<const float* const> inputs, std::span<const float> weights, float* out, int count);

}  // namespace vvr::kernels
