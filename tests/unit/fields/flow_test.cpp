#include "core/fields/flow.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/fields/flows/derivatives.h"
#include "core/fields/flows/linear_system.h"
#include "tests/unit/fields/flow_tools.h"

namespace vvr {
namespace {

/// Every method and solver that gives a flow.
std::vector<fields::FlowOptions> all_methods() {
    std::vector<fields::FlowOptions> all;
    for (const fields::FlowRow& row : fields::flow_methods()) {
        if (row.name == "none") continue;
        fields::FlowOptions options{.method = std::string(row.name)};
        for (const fields::SolverRow& solver : fields::flow_solvers()) {
            options.solver = solver.name;
            all.push_back(options);
            if (row.name != "horn-schunck") break;
        }
    }
    return all;
}

std::string name_of(const fields::FlowOptions& options) {
    return std::string(options.method.row().name) + " " + std::string(options.solver->name);
}

void expect_finite(const fields::Flow& flow, Size size) {
    ASSERT_EQ(flow.u.size(), size);
    ASSERT_EQ(flow.v.size(), size);
    for (const float value : flow.u.pixels()) ASSERT_TRUE(std::isfinite(value));
    for (const float value : flow.v.pixels()) ASSERT_TRUE(std::isfinite(value));
}

fields::PlaneStack derivatives_of(Size size, double u, double v) {
    const std::vector<float> taps = fields::gaussian_taps(1.5);
    std::vector<Plane<float>> planes;
    for (const Plane<std::uint8_t>& grey : test::moving_texture(size, 15, u, v))
        planes.push_back(fields::smoothed(grey, taps));
    std::vector<const Plane<float>*> frames;
    for (const Plane<float>& plane : planes) frames.push_back(&plane);
    fields::PlaneStack result;
    fields::barron_derivatives(frames, taps, test::whole(size), result);
    return result;
}

TEST(FlowChoice, OfNothingHasTheRowThatComputesNothing) {
    const fields::FlowChoice none = fields::FlowChoice::none();
    EXPECT_EQ(&none.row(), &fields::no_flow());
    EXPECT_EQ(none.name(), fields::no_flow().name);
    EXPECT_FALSE(none.is_folder());
    EXPECT_FALSE(fields::has_flow({.method = none}));
}

TEST(Flow, EveryMethodFollowsASlowTexture) {
    const auto frames = test::moving_texture({96, 80}, 15, 0.8, -0.5);
    for (fields::FlowOptions options : all_methods()) {
        // The paper's 60 steps from zero stay far from where they lead.
        if (options.solver == "jacobi" && options.method.name() == "horn-schunck") options.iterations = 2000;
        EXPECT_LT(test::error_of(test::flow_of(frames, 7, options), 0.8, -0.5, 14).end_point, 0.2) << name_of(options);
    }
}

TEST(Flow, NoMotionNoFlow) {
    const auto frames = test::moving_texture({64, 48}, 15, 0, 0);
    for (const fields::FlowOptions& options : all_methods()) {
        // OpenCV's Farneback leaves 0.12 px near the edges of a still picture; a seed needs 0.3.
        const double allowed = options.method.name() == "horn-schunck" ? 1e-4 : 0.25;
        const fields::Flow flow = test::flow_of(frames, 7, options);
        for (const float value : flow.u.pixels()) ASSERT_NEAR(value, 0, allowed) << name_of(options);
        for (const float value : flow.v.pixels()) ASSERT_NEAR(value, 0, allowed) << name_of(options);
    }
}

TEST(Flow, SmallestPicturesHaveFiniteFlow) {
    for (const fields::FlowOptions& options : all_methods()) {
        SCOPED_TRACE(name_of(options));
        for (const Size size : {Size{1, 1}, Size{3, 40}, Size{40, 3}, Size{2, 2}, Size{33, 17}}) {
            for (const int count : {1, 2, 15}) {
                expect_finite(test::flow_of(test::moving_texture(size, count, 1, 1), 0, options), size);
            }
        }
    }
}

TEST(Flow, TheLastFrameMovesLikeTheOneBefore) {
    const auto frames = test::moving_texture({96, 80}, 3, 1.5, 0.5);
    fields::FlowOptions options{.derivatives = "cube"};
    for (const fields::SolverRow& solver : fields::flow_solvers()) {
        if (solver.name == "jacobi") continue;
        options.solver = solver.name;
        EXPECT_LT(test::error_of(test::flow_of(frames, 2, options), 1.5, 0.5, 14).end_point, 0.8) << name_of(options);
    }
}

TEST(Flow, BlackAndWhiteChessboardsStayFinite) {
    std::vector<Plane<std::uint8_t>> frames;
    for (int f = 0; f < 15; ++f) {
        frames.push_back(test::grey_plane({65, 47}, [&](int i, int j) { return (i + j + f) % 2 == 0 ? 0 : 255; }));
    }
    for (fields::FlowOptions options : all_methods()) {
        SCOPED_TRACE(name_of(options));
        options.alpha = 0.01;
        expect_finite(test::flow_of(frames, 7, options), {65, 47});
    }
}

TEST(Pyramid, FollowsFastMotionWhereTheLinearEquationsFail) {
    const auto frames = test::moving_rough_texture({192, 144}, 15, 4.8, -3.6);
    fields::FlowOptions options;
    EXPECT_LT(test::error_of(test::flow_of(frames, 7, options), 4.8, -3.6, 14).end_point, 0.3);
    options.solver = "jacobi";
    EXPECT_GT(test::error_of(test::flow_of(frames, 7, options), 4.8, -3.6, 14).end_point, 3);
}

float mean(const Plane<float>& plane, int i, int j) {
    const auto at = [&](int right, int down) {
        return plane.at(std::clamp(i + right, 0, plane.width() - 1), std::clamp(j + down, 0, plane.height() - 1));
    };
    return (at(0, -1) + at(0, 1) + at(-1, 0) + at(1, 0)) / 6 + (at(-1, -1) + at(1, -1) + at(-1, 1) + at(1, 1)) / 12;
}

/// The paper's iteration (§4.1) as it is written there, point by point.
fields::Flow plain_jacobi(const Plane<float>& ix, const Plane<float>& iy, const Plane<float>& it, float alpha,
                          int steps) {
    fields::Flow flow{Plane<float>(ix.size()), Plane<float>(ix.size())};
    for (int step = 0; step < steps; ++step) {
        fields::Flow next = flow;
        for (int j = 0; j < ix.height(); ++j) {
            for (int i = 0; i < ix.width(); ++i) {
                const float dx = ix.at(i, j);
                const float dy = iy.at(i, j);
                const float u = mean(flow.u, i, j);
                const float v = mean(flow.v, i, j);
                const float error = (dx * u + dy * v + it.at(i, j)) / (alpha * alpha + dx * dx + dy * dy);
                next.u.at(i, j) = u - dx * error;
                next.v.at(i, j) = v - dy * error;
            }
        }
        flow = std::move(next);
    }
    return flow;
}

TEST(Jacobi, EqualsThePlainLoop) {
    for (const Size size : {Size{97, 61}, Size{384, 70}, Size{5, 3}}) {
        const fields::PlaneStack d = derivatives_of(size, 0.7, 0.4);
        for (const float alpha : {0.5F, 10.F}) {
            for (const int steps : {1, 60, 77}) {
                fields::LinearSystem system(size, alpha * alpha);
                system.load(d);
                system.clear();
                system.relax(steps);
                const fields::Flow fast = system.flow();
                const fields::Flow plain = plain_jacobi(d.plane(fields::along_x), d.plane(fields::along_y),
                                                        d.plane(fields::along_t), alpha, steps);
                for (std::size_t i = 0; i < fast.u.pixels().size(); ++i) {
                    ASSERT_NEAR(fast.u.pixels()[i], plain.u.pixels()[i], 1e-4) << size.width << " " << alpha;
                    ASSERT_NEAR(fast.v.pixels()[i], plain.v.pixels()[i], 1e-4) << size.width << " " << alpha;
                }
            }
        }
    }
}

TEST(Multigrid, CyclesLeadWhereJacobiEnds) {
    const Size size{64, 48};
    const fields::PlaneStack d = derivatives_of(size, 0.7, 0.4);
    fields::Multigrid grids;
    const Size other{97, 61};  // what it held before must not matter
    grids.improve(derivatives_of(other, 0.7, 0.4), 4, {Plane<float>(other), Plane<float>(other)});
    fields::Flow flow{Plane<float>(size), Plane<float>(size)};
    for (int i = 0; i < 48; ++i) {
        grids.improve(d, 100, flow);
        flow = grids.finest().flow();
    }
    fields::LinearSystem system(size, 100);
    system.load(d);
    system.clear();
    system.relax(20000);
    const fields::Flow solution = system.flow();
    for (std::size_t i = 0; i < flow.u.pixels().size(); ++i) {
        ASSERT_NEAR(flow.u.pixels()[i], solution.u.pixels()[i], 1e-4);
    }
}

// The flow in a part of the picture is the flow of the whole where it is shown: exactly so for Jacobi, whose steps
// reach one pixel each.
TEST(Parts, JacobiIsTheSameInAPart) {
    const auto frames = test::moving_texture({160, 120}, 15, 0.8, -0.5);
    fields::FlowOptions options{.solver = "jacobi", .iterations = 20};
    const auto method = fields::make_flow(options);
    const fields::Flow all = test::flow_of(frames, 7, options);
    const PixelBox part{33, 21, 103, 82};
    const fields::Flow some = test::flow_in(*method, frames, 7, part);
    for (int j = method->margin(); j < part.height() - method->margin(); ++j) {
        for (int i = method->margin(); i < part.width() - method->margin(); ++i) {
            ASSERT_EQ(some.u.at(i, j), all.u.at(part.left + i, part.top + j));
            ASSERT_EQ(some.v.at(i, j), all.v.at(part.left + i, part.top + j));
        }
    }
}

TEST(Parts, OthersDifferByLessThanCanBeSeen) {
    const auto frames = test::moving_rough_texture({200, 160}, 15, 1.8, -0.9);
    for (const fields::FlowOptions& options : all_methods()) {
        if (options.solver == "jacobi" && options.method.name() == "horn-schunck") continue;
        SCOPED_TRACE(name_of(options));
        const auto method = fields::make_flow(options);
        const fields::Flow all = test::flow_of(frames, 7, options);
        const PixelBox part{41, 29, 161, 129};
        const fields::Flow some = test::flow_in(*method, frames, 7, part);
        ASSERT_EQ(some.u.size(), part.size());
        double sum = 0;
        int count = 0;
        for (int j = method->margin(); j < part.height() - method->margin(); ++j) {
            for (int i = method->margin(); i < part.width() - method->margin(); ++i, ++count) {
                sum += std::hypot(some.u.at(i, j) - all.u.at(part.left + i, part.top + j),
                                  some.v.at(i, j) - all.v.at(part.left + i, part.top + j));
            }
        }
        EXPECT_LT(sum / count, options.method.name() == "horn-schunck" ? 0.01 : 0.1);
    }
}

TEST(Parts, HoldAllThatIsNotZeroWithItsMargin) {
    Plane<std::uint8_t> object({320, 240});
    EXPECT_TRUE(fields::regions_around(object, 10).empty());
    object.at(50, 60) = 1;
    object.at(250, 200) = 1;
    object.at(255, 203) = 1;
    const std::vector<PixelBox> parts = fields::regions_around(object, 10);
    ASSERT_EQ(parts.size(), 2U);
    for (const auto& [x, y] : {std::pair{50, 60}, std::pair{250, 200}, std::pair{255, 203}}) {
        const bool inside = std::ranges::any_of(parts, [x = x, y = y](const PixelBox& p) {
            return p.contains(PixelBox{x, y, x + 1, y + 1}.inflated(10, 10));
        });
        EXPECT_TRUE(inside) << x << ", " << y;
    }
    object.at(0, 0) = 1;
    object.at(319, 239) = 1;
    for (const PixelBox& p : fields::regions_around(object, 60)) {
        EXPECT_TRUE(test::whole({320, 240}).contains(p));
    }
    EXPECT_EQ(fields::regions_around(Plane<std::uint8_t>({320, 240}, 1), 5),
              std::vector<PixelBox>{test::whole({320, 240})});
}

}  // namespace
}  // namespace vvr
