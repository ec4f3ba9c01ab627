// The accuracy of Horn and Schunck's method on patterns of known flow, against the figures of Barron, Fleet and
// Beauchemin, "Performance of optical flow techniques", IJCV 12 (1994), Tables 1 and 2: angle between (u, v, 1) and the
// truth, α = 0.5, 100 steps, a border of 14 pixels left out.
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/fields/flows/derivatives.h"
#include "tests/unit/fields/flow_tools.h"

namespace vvr {
namespace {

constexpr int border = 14;

fields::FlowOptions paper_solver(const char* derivatives) {
    fields::FlowOptions options{.solver = "jacobi", .derivatives = derivatives, .alpha = 0.5, .iterations = 100};
    return options;
}

// "Sinusoid1": two plane waves of 7.8 pixels that move at 1.63 pixels per frame toward 54° and at 1.02 toward -27°;
// both at once are one pattern that moves by (1.585, 0.863). 8 bits, as a camera has.
constexpr double sinusoid_u = 1.585;
constexpr double sinusoid_v = 0.863;

std::vector<Plane<std::uint8_t>> sinusoids() {
    std::vector<Plane<std::uint8_t>> frames;
    const double k = 2 * std::numbers::pi / 7.8;
    const double degree = std::numbers::pi / 180;
    for (int f = -7; f <= 7; ++f) {
        frames.push_back(test::grey_plane({100, 100}, [&](int i, int j) {
            const double one = i * std::cos(54 * degree) + j * std::sin(54 * degree) - 1.63 * f;
            const double other = i * std::cos(-27 * degree) + j * std::sin(-27 * degree) - 1.02 * f;
            return 127.5 + 50 * (std::sin(k * one) + std::sin(k * other));
        }));
    }
    return frames;
}

TEST(Accuracy, OfSinusoidsIsThatOfTheDerivatives) {
    for (const auto& [derivatives, degrees] : {std::pair("barron", 2.53), std::pair("cube", 4.19)}) {
        const fields::Flow flow = test::flow_of(sinusoids(), 7, paper_solver(derivatives));
        EXPECT_NEAR(test::error_of(flow, sinusoid_u, sinusoid_v, border).angle, degrees, 0.15) << derivatives;
    }
}

// "Square2": 40 × 40 pixels that move by (4/3, 4/3), made three times as large, blurred by three of the large pixels
// and reduced. A square's sides show motion across them only, so the error must be large.
TEST(Accuracy, SquareHasTheApertureProblem) {
    std::vector<Plane<std::uint8_t>> frames;
    const std::vector<float> blur = fields::gaussian_taps(3);
    for (int f = -7; f <= 7; ++f) {
        const auto inside = [f](int p) { return p >= 90 + 4 * f && p < 210 + 4 * f; };
        const Plane<std::uint8_t> large =
            test::grey_plane({300, 300}, [&](int i, int j) { return inside(i) && inside(j) ? 0 : 255; });
        const Plane<float> blurred = fields::smoothed(large, blur);
        frames.push_back(test::grey_plane({100, 100}, [&](int i, int j) { return blurred.at(3 * i + 1, 3 * j + 1); }));
    }
    const fields::Flow flow = test::flow_of(frames, 7, paper_solver("barron"));
    EXPECT_NEAR(test::error_of(flow, 4.0 / 3, 4.0 / 3, border).angle, 32, 1.5);
}

TEST(Accuracy, ConvergedSolverHalvesTheErrorOfSixtySteps) {
    for (const auto& [u, v] : {std::array{0.8, -0.5}, std::array{1.2, 0.9}}) {
        const auto frames = test::moving_texture({192, 144}, 15, u, v);
        fields::FlowOptions options{.solver = "jacobi"};
        const double jacobi = test::error_of(test::flow_of(frames, 7, options), u, v, border).angle;
        options.iterations = 2000;
        const double converged = test::error_of(test::flow_of(frames, 7, options), u, v, border).angle;
        EXPECT_LT(converged, jacobi / 2) << "60 steps: " << jacobi;
    }
}

}  // namespace
}  // namespace vvr
