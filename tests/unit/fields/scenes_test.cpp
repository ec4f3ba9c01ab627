// Whole clips of which everything is known.
#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/fields/pipeline.h"
#include "tests/scene/scene.h"
#include "tests/scene/scene_source.h"
#include "tests/unit/fields/flow_tools.h"

namespace vvr {
namespace {

SourceOptions in_colour() {
    SourceOptions options;
    options.colour = true;
    options.field_size = {-1, -1};
    return options;
}

std::vector<Field> fields_of(const scene::Scene& scene, const FieldOptions& options) {
    std::vector<Field> fields;
    compute_fields(*scene::open_scene(scene, in_colour()), options,
                   [&](const SharedFrame&, Field&& field) { fields.push_back(std::move(field)); });
    return fields;
}

const scene::Object* find(const scene::Truth& truth, const std::string& name) {
    const auto found = std::ranges::find(truth.objects, name, &scene::Object::name);
    return found == truth.objects.end() ? nullptr : &*found;
}

int area(const Plane<std::uint8_t>& plane) {
    return static_cast<int>(std::ranges::count_if(plane.pixels(), [](int p) { return p > 0; }));
}

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
scene::Options bad_camera(int frames) {
    scene::Options options;
    options.frames = frames;
    options.noise = 5;
    options.drift = 25;
    options.jump = -51;
    options.jump_at = frames / 2;
    return options;
}

struct LeftBagCase {
    std::string name;
    std::string reference;
    bool bad;
};

std::ostream& operator<<(std::ostream& out, const LeftBagCase& c) {
    return out << c.name;
}

class LeftBag : public testing::TestWithParam<LeftBagCase> {};

// The bag lies there for two thirds of the clip: it must stay visible for all that time, and nothing of it may move.
TEST_P(LeftBag, StaysVisibleAndStill) {
    constexpr int count = 320;
    scene::Options scene_options = GetParam().bad ? bad_camera(count) : scene::Options{};
    scene_options.frames = count;
    const scene::Scene scene = scene::make_left_bag(scene_options);
    const scene::LeftBag facts = scene::left_bag_facts(scene_options);
    FieldOptions options;
    options.reference = GetParam().reference;
    options.seeds.grid = 4;
    const std::vector<Field> fields = fields_of(scene, options);
    ASSERT_EQ(fields.size(), static_cast<std::size_t>(count));

    int alone = 0, good = 0, visible = 0, empty = 0, dark = 0;
    for (int f = 0; f < count; ++f) {
        const scene::Truth truth = scene.truth(f);
        const scene::Object* const bag = find(truth, "bag");
        const scene::Object* const person = find(truth, "person");
        const Field& field = fields[static_cast<std::size_t>(f)];
        if (truth.objects.empty()) {
            ++empty;
            dark += area(field.scalar) == 0 ? 1 : 0;
        }
        // While somebody is near, it is not the bag alone that is seen there.
        const bool near = person != nullptr && std::abs(person->x - facts.x) < 60;
        if (bag == nullptr || near || f < facts.put_down || f >= facts.taken_up) continue;
        ++alone;
        const double iou = overlap(field.scalar, bag->mask, 4);
        // What is faint beside it counts too where it touches the bag: some of its shadow, and its handle's hole.
        good += iou > 0.75 ? 1 : 0;
        visible += iou > 0.5 ? 1 : 0;
        for (const Seed& seed : field.seeds) {
            EXPECT_GT(std::hypot(seed.x - facts.x, seed.y - facts.y), 20) << "a seed on the still bag in frame " << f;
        }
    }
    ASSERT_GT(alone, count / 3);
    EXPECT_EQ(visible, alone);
    // Noise eats away at edges that are soft to begin with.
    EXPECT_GE(good, (GetParam().bad ? 0.5 : 0.95) * alone) << "of " << alone;
    ASSERT_GT(empty, 10);
    EXPECT_EQ(dark, empty);
}

INSTANTIATE_TEST_SUITE_P(All, LeftBag,
                         testing::Values(LeftBagCase{"median", "median", false}, LeftBagCase{"first", "first", false},
                                         LeftBagCase{"running", "running", false},
                                         LeftBagCase{"median_bad_camera", "median", true},
                                         LeftBagCase{"running_bad_camera", "running", true}),
                         [](const auto& test) { return test.param.name; });

TEST(Still, NothingLightsUpInNoiseAndChangingLight) {
    const scene::Scene scene = scene::make_still(bad_camera(60));
    for (const char* const filter : {"difference", "temporal", "hull", "bands"}) {
        FieldOptions options;
        options.filter = filter;
        for (const Field& field : fields_of(scene, options)) {
            ASSERT_EQ(area(field.scalar), 0) << filter << " " << field.index;
            ASSERT_TRUE(field.seeds.empty());
        }
    }
}

TEST(ShiftedTexture, ThePyramidFollowsSixPixelsAFrame) {
    scene::Options options;
    options.frames = 5;
    options.u = 4.8;
    options.v = -3.6;
    const scene::Scene scene = scene::make_shifted_texture(options);
    FieldOptions fields;
    fields.filter = "luminance";
    fields.flow.area = "all";
    const std::vector<Field> result = fields_of(scene, fields);
    EXPECT_LT(test::error_of(result[2].flow, options.u, options.v, 14).end_point, 0.3);
    EXPECT_LT(test::error_of(result[4].flow, options.u, options.v, 14).end_point, 0.3) << "the last frame";
    fields.flow.solver = "jacobi";
    EXPECT_GT(test::error_of(fields_of(scene, fields)[2].flow, options.u, options.v, 14).end_point, 2);
}

TEST(ShiftedTexture, ConvergenceHalvesTheErrorOfSixtySteps) {
    scene::Options options;
    options.frames = 15;
    options.u = 0.9;
    options.v = 0.5;
    const scene::Scene scene = scene::make_shifted_texture(options);
    FieldOptions fields;
    fields.filter = "luminance";
    fields.flow.area = "all";
    fields.flow.every = 7;
    const auto angle = [&](const char* solver) {
        fields.flow.solver = solver;
        return test::error_of(fields_of(scene, fields)[7].flow, options.u, options.v, 14).angle;
    };
    const double jacobi = angle("jacobi");
    EXPECT_LT(angle("multigrid"), jacobi / 2);
    EXPECT_LT(angle("pyramid"), jacobi / 2);
}

TEST(SpinningSphere, FlowTurns) {
    scene::Options options;
    options.frames = 5;
    const scene::Scene scene = scene::make_spinning_sphere(options);
    FieldOptions fields;
    fields.filter = "luminance";
    fields.flow.area = "all";
    const Field field = fields_of(scene, fields)[2];
    const scene::Truth truth = scene.truth(2);
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
    const scene::Scene scene = scene::make_walkers({});
    for (const char* const solver : {"jacobi", "multigrid", "pyramid"}) {
        FieldOptions fields;
        fields.reference = "first";
        fields.flow.solver = solver;
        fields.flow.every = 20;
        fields.span.start = 10;
        fields.span.end = 12;
        const std::vector<Field> parts = fields_of(scene, fields);
        fields.flow.area = "all";
        const std::vector<Field> whole = fields_of(scene, fields);
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
    const scene::Scene scene = scene::make_walkers({});
    FieldOptions fields;
    fields.reference = "first";
    fields.flow.every = 25;
    fields.span.start = 5;
    fields.span.end = 20;
    int seen = 0, followed = 0;
    for (const Field& field : fields_of(scene, fields)) {
        if (field.flow.u.empty()) continue;
        for (const scene::Object& walker : scene.truth(static_cast<int>(field.index)).objects) {
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
