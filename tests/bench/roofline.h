#pragma once

#include <cstddef>

namespace vvr::bench {

/// What one core of this machine gives at best: multiplications and additions of floats a second, by the widest vectors
/// that our kernels use.
double peak_flops();

/// Bytes a second of a = b + s c over three arrays that take `bytes` together.
double triad_bytes(std::size_t bytes);

}  // namespace vvr::bench
