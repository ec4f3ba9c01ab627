#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/fields/flow.h"
#include "tests/unit/fields_pictures.h"

namespace vvr {
namespace {

Flow flow_of(const std::vector<Frame>& frames, std::size_t middle, const FlowOptions& options) {
    const auto method = make_flow(options);
    std::vector<FlowFrame> prepared;
    for (const Frame& frame : frames) prepared.push_back(method->prepare(frame.grey));
    std::vector<const FlowFrame*> about;
    for (int k = -method->reach(); k <= method->reach(); ++k) {
        const int f = std::clamp(static_cast<int>(middle) + k, 0, static_cast<int>(frames.size()) - 1);
        about.push_back(&prepared[static_cast<std::size_t>(f)]);
    }
    return (*method)(about, {0, 0, frames.front().grey.size()});
}

std::vector<Frame> moving_texture(Size size, int count, double u, double v) {
    std::vector<Frame> frames;
    for (int f = 0; f < count; ++f) frames.push_back(test::texture_frame(size, f, u, v));
    return frames;
}

TEST(HornSchunck, FollowsAShiftedTexture) {
    const std::vector<Frame> frames = moving_texture({96, 80}, 15, 0.8, -0.5);
    const Flow flow = flow_of(frames, 7, {.solver = "jacobi", .alpha = 2, .iterations = 200});
    double error = 0;
    int count = 0;
    for (int j = 14; j < 80 - 14; ++j) {
        for (int i = 14; i < 96 - 14; ++i, ++count) {
            error += std::hypot(flow.u.at(i, j) - 0.8, flow.v.at(i, j) + 0.5);
        }
    }
    EXPECT_LT(error / count, 0.03);
}

TEST(HornSchunck, NoMotionNoFlow) {
    const Flow flow = flow_of(moving_texture({64, 48}, 15, 0, 0), 7, {});
    for (const float value : flow.u.pixels()) ASSERT_NEAR(value, 0, 1e-5);
    for (const float value : flow.v.pixels()) ASSERT_NEAR(value, 0, 1e-5);
}

TEST(HornSchunck, SmallestInputsHaveFiniteFlow) {
    for (const Size size : {Size{1, 1}, Size{3, 40}, Size{40, 3}, Size{2, 2}}) {
        for (const int count : {1, 2, 15}) {
            const Flow flow = flow_of(moving_texture(size, count, 1, 1), 0, {.alpha = 0.001});
            ASSERT_EQ(flow.u.size(), size);
            for (const float value : flow.u.pixels()) ASSERT_TRUE(std::isfinite(value));
            for (const float value : flow.v.pixels()) ASSERT_TRUE(std::isfinite(value));
        }
    }
}

TEST(FlowTable, UnknownNameSaysWhatThereIs) {
    try {
        make_flow({.method = "horn"});
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_NE(std::string(error.what()).find("horn-schunck"), std::string::npos);
    }
    EXPECT_EQ(make_flow({.method = "none"}), nullptr);
}

}  // namespace
}  // namespace vvr
