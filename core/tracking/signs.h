#pragma once

#include <array>
#include <string_view>

// Whether something is an event.
namespace vvr::tracking {

/// What speaks for an object, or against it, and how much. tests/bench/fit_signs.py fits the weights.
struct Sign {
    std::string_view name;
    double weight;
};
inline constexpr std::array sign_table{
    Sign{"texture", -3.58},  // correlation of its gradients with the empty scene's, 0 to 1: a bush, clouds in a bonnet
    Sign{"straight", 1.31},  // as `straightness_of`, -0.5 to 1: leaves and rain turn back
    Sign{"duration", 1.67},  // logarithm of its seconds, up to 20
    Sign{"area", 0.55},      // logarithm of its share of the picture
    Sign{"seen", 3.82},      // share of its frames in which it was seen
    Sign{"border", 1.31},    // 1 = it entered or left at the border of the picture
    Sign{"part", -1.58},     // 1 = it came out of another
    Sign{"settled", -0.79},  // 1 = it was stationary
};
inline constexpr double sign_bias = -3.68;

using Signs = std::array<double, sign_table.size()>;

/// The probability that somebody would count it as an object that was there (logistic regression).
double probability_of(const Signs& signs);

}  // namespace vvr::tracking
