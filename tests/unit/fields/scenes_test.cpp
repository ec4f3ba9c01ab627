// Whole clips of which everything is known.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/scene/scene.h"
#include "tests/unit/fields/flow_tools.h"

namespace vvr {
namespace {

using test::fields_of;

/// How much the scalar field within `border` pixels of a mask is that mask: intersection over union.
double overlap(const Plane<std::uint8_t>& scalar, const Plane<std::uint8_t>& mask, int border) {
    int both = 0, either = 0;
    for (int j = 0; j < mask.height(); ++j) {
        for (int i = 0; i < mask.width(); ++i) {
            bool near = false;
            for (int y = std::max(j - border, 0); y <= std::min(j + border, mask.height() - 1) && !near; ++y) {
                for (int x = std::max(i - border, 0); x <= std::min(i + border, mask.width() - 1) && !near; ++x) {
                    near = mask.at(x, y) != 0;
                }
            }
            const bool shown = near && scalar.at(i, j) != 0;
            const bool there = mask.at(i, j) != 0;
            both += shown && there ? 1 : 0;
            either += shown || there ? 1 : 0;
        }
    }
    return either == 0 ? 1 : static_cast<double>(both) / either;
}

/// Noise and light that no object may be confused with: σ = 5, and a jump by a fifth of the range.
generator::Options bad_camera(int frames) {
    generator::Options options{.frames = frames, .noise = 5, .drift = 25, .jump = -51, .jump_at = frames / 2};
    return options;
}

/// The reference, and whether the camera is bad.
class LeftBag : public testing::TestWithParam<std::pair<std::string, bool>> {};

// The bag lies there for two thirds of the clip: it must stay visible for all that time, and nothing of it may move.
TEST_P(LeftBag, StaysVisibleAndStill) {
    constexpr int count = 320;
    const auto& [reference, bad] = GetParam();
    generator::Options scene_options = bad ? bad_camera(count) : generator::Options{};
    scene_options.frames = count;
    const generator::Scene scene = generator::make_left_bag(scene_options);
    const generator::LeftBag facts = generator::left_bag_facts(scene_options);
    fields::FieldOptions options{.reference = reference};
    options.seeds.grid = 4;
    const std::vector<fields::Field> fields = fields_of(scene, options);
    ASSERT_EQ(fields.size(), static_cast<std::size_t>(count));

    int alone = 0, good = 0, visible = 0, empty = 0, dark = 0;
    for (int f = 0; f < count; ++f) {
        const generator::Truth truth = scene.truth(f);
        const generator::Object* const bag = truth.find("bag");
        const generator::Object* const person = truth.find("person");
        const fields::Field& field = fields[static_cast<std::size_t>(f)];
        if (truth.objects.empty()) {
            ++empty;
            dark += test::lit(field.scalar) == 0 ? 1 : 0;
        }
        // While somebody is near, it is not the bag alone that is seen there.
        const bool near = person != nullptr && std::abs(person->x - facts.x) < 60;
        if (bag == nullptr || near || f < facts.put_down || f >= facts.taken_up) continue;
        ++alone;
        const double iou = overlap(field.scalar, bag->mask, 4);
        // What is faint beside it counts too where it touches the bag: some of its shadow, and its handle's hole.
        good += iou > 0.75 ? 1 : 0;
        visible += iou > 0.5 ? 1 : 0;
        for (const fields::Seed& seed : field.seeds) {
            EXPECT_GT(std::hypot(seed.x - facts.x, seed.y - facts.y), 20) << "a seed on the still bag in frame " << f;
        }
    }
    ASSERT_GT(alone, count / 3);
    EXPECT_EQ(visible, alone);
    // Noise eats away at edges that are soft to begin with.
    EXPECT_GE(good, (bad ? 0.5 : 0.95) * alone) << "of " << alone;
    ASSERT_GT(empty, 10);
    EXPECT_EQ(dark, empty);
}

std::string variant_name(const testing::TestParamInfo<std::pair<std::string, bool>>& test) {
    return test.param.first + (test.param.second ? "_bad_camera" : "");
}

INSTANTIATE_TEST_SUITE_P(Quick, LeftBag, testing::Values(std::pair("median", false), std::pair("running", true)),
                         variant_name);
INSTANTIATE_TEST_SUITE_P(Nightly, LeftBag,
                         testing::Values(std::pair("first", false), std::pair("running", false),
                                         std::pair("median", true)),
                         variant_name);

TEST(Still, NothingLightsUpInNoiseAndChangingLight) {
    const generator::Scene scene = generator::make_still(bad_camera(60));
    for (const char* const filter : {"difference", "temporal", "hull", "bands"}) {
        fields::FieldOptions options{.filter = filter};
        for (const fields::Field& field : fields_of(scene, options)) {
            ASSERT_EQ(test::lit(field.scalar), 0) << filter << " " << field.index;
            ASSERT_TRUE(field.seeds.empty());
        }
    }
}

TEST(SpinningSphere, FlowTurns) {
    generator::Options options{.frames = 5};
    const generator::Scene scene = generator::make_spinning_sphere(options);
    fields::FieldOptions fields{.filter = "luminance"};
    const fields::Field field = fields_of(scene, fields)[2];
    const generator::Truth truth = scene.truth(2);
    double sum = 0;
    int count = 0;
    for (int j = 0; j < scene.size().height; ++j) {
        for (int i = 0; i < scene.size().width; ++i) {
            if (truth.u.at(i, j) == 0 && truth.v.at(i, j) == 0) continue;
            sum += std::hypot(field.flow.u.at(i, j) - truth.u.at(i, j), field.flow.v.at(i, j) - truth.v.at(i, j));
            ++count;
        }
    }
    ASSERT_GT(count, 1000);
    EXPECT_LT(sum / count, 0.3);
}

// What is shown must not depend on whether the rest of the picture was looked at.
TEST(Walkers, FlowIsTheSameWhereOnlyPartsAreLookedAt) {
    const generator::Scene scene = generator::make_walkers({});
    for (const char* const solver : {"jacobi", "pyramid"}) {
        fields::FieldOptions fields{.reference = "first"};
        fields.flow.solver = solver;
        fields.flow.every = 20;
        fields.span.start = 10;
        fields.span.end = 12;
        const std::vector<fields::Field> parts = fields_of(scene, fields);
        fields.seeds.area = "field";  // needs flow in the whole frame
        const std::vector<fields::Field> whole = fields_of(scene, fields);
        ASSERT_EQ(parts.size(), 50U);
        double sum = 0, most = 0;
        int count = 0;
        for (std::size_t f = 0; f < parts.size(); ++f) {
            if (parts[f].flow.u.empty()) continue;
            for (std::size_t i = 0; i < parts[f].scalar.pixels().size(); ++i) {
                if (parts[f].scalar.pixels()[i] == 0) continue;
                const double difference = std::hypot(parts[f].flow.u.pixels()[i] - whole[f].flow.u.pixels()[i],
                                                     parts[f].flow.v.pixels()[i] - whole[f].flow.v.pixels()[i]);
                sum += difference;
                most = std::max(most, difference);
                ++count;
            }
        }
        ASSERT_GT(count, 500);
        const bool exact = std::string(solver) == "jacobi";
        EXPECT_LE(sum / count, exact ? 0 : 0.02) << solver;
        EXPECT_LE(most, exact ? 0 : 0.5) << solver;
    }
}

// Everybody's way is found: the mean flow on a walker is the truth within a quarter, or half a pixel.
TEST(Walkers, TheDefaultFlowFollowsEachOfThem) {
    const generator::Scene scene = generator::make_walkers({});
    fields::FieldOptions fields{.reference = "first"};
    fields.flow.every = 25;
    fields.span.start = 5;
    fields.span.end = 20;
    int seen = 0, followed = 0;
    for (const fields::Field& field : fields_of(scene, fields)) {
        if (field.flow.u.empty()) continue;
        for (const generator::Object& walker : scene.truth(static_cast<int>(field.index)).objects) {
            double u = 0, v = 0;
            int count = 0;
            for (std::size_t i = 0; i < walker.mask.pixels().size(); ++i) {
                if (walker.mask.pixels()[i] == 0) continue;
                u += field.flow.u.pixels()[i];
                v += field.flow.v.pixels()[i];
                ++count;
            }
            if (count < 200) continue;
            ++seen;
            const double error = std::hypot(u / count - walker.vx, v / count - walker.vy);
            followed += error < std::max(0.5, 0.25 * std::hypot(walker.vx, walker.vy)) ? 1 : 0;
        }
    }
    ASSERT_GT(seen, 10);
    EXPECT_GE(followed, 0.9 * seen) << "of " << seen;
}

}  // namespace
}  // namespace vvr
