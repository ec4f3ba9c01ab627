#include "core/tracking/signs.h"

#include <cmath>
#include <cstddef>

namespace vvr::tracking {

double probability_of(const Signs& signs) {
    double sum = sign_bias;
    for (std::size_t k = 0; k < signs.size(); ++k) sum += sign_table[k].weight * signs[k];
    return 1 / (1 + std::exp(-sum));
}

}  // namespace vvr::tracking
