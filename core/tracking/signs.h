#pragma once

#include <array>
#include <string_view>

#ifdef VVR_NUMBERS_VARY
#define VVR_NUMBERS inline  // tests/bench/events.cpp tries others
#else
#define VVR_NUMBERS inline constexpr
#endif

// Whether something is an event.
namespace vvr::tracking {

/// What speaks for an object, or against it, and how much. tests/bench/events.py fits the weights.
struct Sign {
    std::string_view name;
    double weight;
};
VVR_NUMBERS std::array sign_table{
    Sign{"texture", -5.20},  // correlation of its gradients with the empty scene's, 0 to 1: a bush, clouds in a bonnet
    Sign{"straight", 1.42},  // as `straightness_of`, -0.5 to 1: leaves and rain turn back
    Sign{"duration", 1.60},  // logarithm of its seconds, up to 20
    Sign{"area", 0.56},      // logarithm of its share of the picture
    Sign{"seen", 2.80},      // share of its frames in which it was seen: rain comes and goes
    Sign{"part", -1.73},     // share of what it came out of that is not it; 1 where nobody knows
    Sign{"settled", -1.76},  // 1 = it was stationary
};
VVR_NUMBERS double sign_bias = -2.11;

using Signs = std::array<double, sign_table.size()>;

/// The probability that somebody would count it as an object that was there (logistic regression).
double probability_of(const Signs& signs);

}  // namespace vvr::tracking
