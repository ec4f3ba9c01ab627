#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/fields/filter.h"
#include "core/fields/norm.h"
#include "core/fields/pipeline.h"
#include "tests/unit/fields/pictures.h"

namespace vvr {
namespace {

constexpr Size size{64, 48};

EmptyScene scene_of(const Frame& empty) {
    EmptyScene scene;
    scene.reference = Planes{empty.grey, empty.colour};
    return scene;
}

EmptyScene black(Size of) {
    return scene_of(test::flat_frame(of, 0, 0));
}

/// A bright square that walks to the right by four pixels per frame, over a texture.
Frame walker(std::int64_t index) {
    Frame frame = test::texture_frame(size, 0, 0, 0);
    frame.index = index;
    frame.pts = static_cast<double>(index) / 25;
    for (std::uint8_t& p : frame.grey.pixels()) p = static_cast<std::uint8_t>(30 + p / 4);
    const int left = static_cast<int>(4 * index);
    for (int j = 16; j < 32; ++j) {
        for (int i = std::max(left, 0); i < std::min(left + 12, size.width); ++i) frame.grey.at(i, j) = 220;
    }
    return frame;
}

Frame with_colour(std::int64_t index) {
    Frame frame = walker(index);
    frame.colour = Plane<Bgr>(size);
    std::ranges::transform(frame.grey.pixels(), frame.colour.pixels().begin(), [](std::uint8_t g) {
        return Bgr{g, g, g};
    });
    return frame;
}

std::vector<Field> fields_of(const FieldOptions& options, int count, Frame (*make)(std::int64_t) = walker) {
    const Frame empty = make(1000);
    std::vector<Field> fields;
    const FrameReader read = [&, next = 0]() mutable -> FrameJob {
        if (next == count) return {};
        return [make, index = next++] { return make(index); };
    };
    compute_fields(read, scene_of(empty), options,
                   [&](const SharedFrame&, Field&& field) { fields.push_back(std::move(field)); });
    return fields;
}

/// Without whatever would change a pixel for its neighbours' sake.
FieldOptions exact(const std::string& filter) {
    FieldOptions options;
    options.filter = filter;
    options.smooth = 0;
    options.min_area = 0;
    options.illumination = "none";
    options.flow.method = "none";
    options.threads = 2;
    return options;
}

TEST(Filters, DifferenceIsTwiceWhatDiffers) {
    const Plane<std::uint8_t> scalar = fields_of(exact("difference"), 4)[3].scalar;
    EXPECT_EQ(scalar.at(14, 20), 255);
    EXPECT_EQ(scalar.at(11, 20), 0);
    EXPECT_EQ(scalar.at(24, 20), 0);
}

TEST(Filters, HullIsTheSilhouette) {
    const Plane<std::uint8_t> scalar = fields_of(exact("hull"), 4)[3].scalar;
    EXPECT_EQ(std::ranges::count(scalar.pixels(), 255), 12 * 16);
    EXPECT_EQ(std::ranges::count(scalar.pixels(), 0), size.width * size.height - 12 * 16);
}

TEST(Filters, BandsTellWhatBecameOfAPixel) {
    const std::vector<Field> fields = fields_of(exact("bands"), 4);
    const Plane<std::uint8_t>& first = fields[0].scalar;
    EXPECT_EQ(std::ranges::count(first.pixels(), static_cast<int>(Band::newly_covered)), 12 * 16)
        << "before was nothing";
    const Plane<std::uint8_t>& scalar = fields[3].scalar;
    EXPECT_EQ(scalar.at(5, 20), static_cast<int>(Band::background));
    EXPECT_EQ(scalar.at(9, 20), static_cast<int>(Band::uncovered));
    EXPECT_EQ(scalar.at(15, 20), static_cast<int>(Band::still_covered));
    EXPECT_EQ(scalar.at(21, 20), static_cast<int>(Band::newly_covered));
    EXPECT_EQ(std::ranges::count(scalar.pixels(), static_cast<int>(Band::uncovered)), 4 * 16);
    EXPECT_EQ(std::ranges::count(scalar.pixels(), static_cast<int>(Band::still_covered)), 8 * 16);
    EXPECT_EQ(std::ranges::count(scalar.pixels(), static_cast<int>(Band::newly_covered)), 4 * 16);
}

TEST(Filters, SignedTellsDarkerFromBrighter) {
    // A dark square and a bright one on grey.
    const auto make = [](int index) {
        return Frame{index,
                     index / 25.0,
                     test::grey_plane(size, [](int i, int) { return i < 8    ? 60
                                                                    : i < 16 ? 160
                                                                             : 100; }),
                     {}};
    };
    const Frame empty{0, 0, Plane<std::uint8_t>(size, 100), {}};
    const FrameReader read = [&, next = 0]() mutable -> FrameJob {
        if (next++ == 1) return {};
        return [&] { return make(0); };
    };
    compute_fields(read, scene_of(empty), exact("signed"), [](const SharedFrame&, Field&& field) {
        EXPECT_EQ(field.scalar.at(3, 20), 128 - 40);
        EXPECT_EQ(field.scalar.at(12, 20), 128 + 60);
        EXPECT_EQ(field.scalar.at(30, 20), 0);
    });
}

TEST(Values, JoinByTheirKind) {
    const auto bands = [](Band a, Band b) {
        return static_cast<Band>(joined(Values::band, static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)));
    };
    using enum Band;
    // From before the first frame to the last.
    EXPECT_EQ(bands(newly_covered, still_covered), newly_covered);
    EXPECT_EQ(bands(still_covered, still_covered), still_covered);
    EXPECT_EQ(bands(still_covered, uncovered), uncovered);
    EXPECT_EQ(bands(uncovered, background), uncovered);
    EXPECT_EQ(bands(uncovered, newly_covered), still_covered);
    EXPECT_EQ(bands(background, newly_covered), newly_covered);
    EXPECT_EQ(bands(background, background), background);
    EXPECT_EQ(bands(newly_covered, uncovered), newly_covered) << "it came and went, and is not lost";
    EXPECT_EQ(bands(newly_covered, background), newly_covered);
    EXPECT_EQ(joined(Values::strength, 20, 90), 90);
    EXPECT_EQ(joined(Values::sign, 20, 200), 20) << "farther from the middle";
    EXPECT_EQ(joined(Values::sign, 120, 200), 200);
    EXPECT_EQ(joined(Values::sign, 0, 127), 127);
    EXPECT_EQ(joined(Values::sign, 127, 0), 127);
}

TEST(Norms, SayWhatDiffers) {
    const auto of = [](const Bgr& colour) {
        const auto grey = static_cast<std::uint8_t>((colour[0] + colour[1] + colour[2]) / 3);
        return Planes{Plane<std::uint8_t>({1, 1}, grey), Plane<Bgr>({1, 1}, colour)};
    };
    const auto differ = [&](std::string_view norm, const Bgr& a, const Bgr& b) {
        return static_cast<int>(find_norm(norm, of(a)).difference(of(a), of(b)).at(0, 0));
    };
    const Bgr blue{200, 100, 0};
    const Bgr red{0, 100, 200};
    EXPECT_EQ(differ("channel", blue, red), 200);
    EXPECT_EQ(differ("luminance", blue, red), 0) << "as bright";
    EXPECT_EQ(differ("hue", blue, red), 255) << "346 would be more than there is";
    EXPECT_EQ(differ("hue", {40, 40, 40}, {200, 200, 200}), 0) << "greys differ in brightness alone";
    // Of the hues' plane: red 200 0 0 is at (200, 0), green 0 200 0 at (-100, 173).
    EXPECT_NEAR(differ("hue", {0, 0, 100}, {0, 100, 0}), std::hypot(150, 86.6), 1);
    EXPECT_NEAR(differ("hue", {0, 0, 100}, {50, 50, 100}), 50, 1) << "less of the same hue";
    const Planes grey{Plane<std::uint8_t>({1, 1}), {}};
    EXPECT_THROW(find_norm("hue", grey), Error);
    EXPECT_NO_THROW(find_norm("luminance", grey));
    EXPECT_THROW(find_norm("loudness", grey), Error);
}

TEST(Filters, TemporalShowsWhatChangedSinceTheFrameBefore) {
    const std::vector<Field> fields = fields_of(exact("temporal"), 4);
    EXPECT_EQ(std::ranges::count(fields[0].scalar.pixels(), 0), size.width * size.height);
    const Plane<std::uint8_t>& scalar = fields[3].scalar;
    EXPECT_EQ(std::ranges::count_if(scalar.pixels(), [](int p) { return p > 0; }), 2 * 4 * 16);
    EXPECT_EQ(scalar.at(9, 20), 255);
    EXPECT_EQ(scalar.at(15, 20), 0);
    EXPECT_EQ(scalar.at(21, 20), 255);
}

TEST(Filters, EdgesAreSteepPlaces) {
    const FieldOptions options = exact("edges");
    const Plane<std::uint8_t> scalar = fields_of(options, 4)[3].scalar;
    EXPECT_GT(scalar.at(12, 24), 50);
    EXPECT_EQ(scalar.at(18, 24), 0) << "inside the square all is even";
    const FrameReader step = [next = 0]() mutable -> FrameJob {
        if (next++ == 1) return {};
        return [] { return Frame{0, 0, test::grey_plane({8, 8}, [](int i, int) { return i < 4 ? 0 : 255; }), {}}; };
    };
    compute_fields(step, black({8, 8}), options, [](const SharedFrame&, Field&& field) {
        EXPECT_EQ(field.scalar.at(3, 4), 255) << "black beside white";
        EXPECT_EQ(field.scalar.at(4, 4), 255);
        EXPECT_EQ(field.scalar.at(1, 4), 0);
    });
}

TEST(Filters, LuminanceIsTheVideo) {
    const Plane<std::uint8_t> scalar = fields_of(exact("luminance"), 4)[3].scalar;
    EXPECT_TRUE(std::ranges::equal(scalar.pixels(), walker(3).grey.pixels()));
}

TEST(Filters, FlowIsItsMagnitude) {
    FieldOptions options = exact("flow");
    EXPECT_EQ(std::ranges::count(fields_of(options, 3)[1].scalar.pixels(), 0), size.width * size.height)
        << "without a flow method there is none to show";
    options.flow.method = "horn-schunck";
    options.flow.every = 1000;
    options.threshold = 0;
    std::vector<Field> fields;
    const FrameReader read = [next = 0]() mutable -> FrameJob {
        if (next == 3) return {};
        return [index = next++] { return test::texture_frame({96, 80}, index, 3, 0); };
    };
    compute_fields(read, black({96, 80}), options,
                   [&](const SharedFrame&, Field&& field) { fields.push_back(std::move(field)); });
    EXPECT_NEAR(fields[1].scalar.at(48, 40), 24 * 3, 4);
    EXPECT_FALSE(fields[0].seeds.empty());
    EXPECT_TRUE(fields[1].seeds.empty()) << "flow was not asked for there, only needed";
}

TEST(Filters, BackgroundModelsLearnTheScene) {
    for (const char* const name : {"mog2", "knn"}) {
        for (const auto make : {walker, with_colour}) {
            const std::vector<Field> fields = fields_of(exact(name), 14, make);
            const Plane<std::uint8_t>& scalar = fields[10].scalar;
            EXPECT_EQ(scalar.at(45, 24), 255) << name;
            EXPECT_EQ(scalar.at(5, 5), 0) << name;
            EXPECT_EQ(scalar.at(60, 24), 0) << name;
        }
    }
}

TEST(Filters, ThresholdRegionAndAreaHoldForAll) {
    for (const FilterRow& row : filters()) {
        FieldOptions options = exact(std::string(row.name));
        options.threshold = 255;
        const Frame empty = walker(1000);
        EmptyScene scene = scene_of(empty);
        scene.region = Plane<std::uint8_t>(size, 255);
        for (int j = 0; j < 24; ++j) std::ranges::fill(scene.region.row(j), std::uint8_t{0});
        const FrameReader read = [next = 0]() mutable -> FrameJob {
            if (next == 8) return {};
            return [index = next++] { return walker(index); };
        };
        compute_fields(read, scene, options, [&](const SharedFrame&, Field&& field) {
            for (int j = 0; j < 24; ++j) ASSERT_EQ(std::ranges::count(field.scalar.row(j), 0), size.width) << row.name;
            for (const int p : field.scalar.pixels()) {
                ASSERT_TRUE(p == 0 || p == 255 || row.traits.values != Values::strength) << row.name << " " << p;
            }
        });
    }
}

TEST(Filters, ASecondOneGivesWhatItGivesAlone) {
    for (const FilterRow& row : filters()) {
        for (const char* const first : {"difference", "luminance", "mog2"}) {
            FieldOptions options = exact(std::string(row.name));
            options.flow.method = "horn-schunck";
            const std::vector<Field> alone = fields_of(options, 6, with_colour);
            options.filter = first;
            const std::vector<Field> without = fields_of(options, 6, with_colour);
            options.second = row.name;
            const std::vector<Field> both = fields_of(options, 6, with_colour);
            for (std::size_t f = 0; f < both.size(); ++f) {
                ASSERT_TRUE(std::ranges::equal(both[f].second.pixels(), alone[f].scalar.pixels()))
                    << first << " " << row.name << " " << f;
                ASSERT_TRUE(std::ranges::equal(both[f].scalar.pixels(), without[f].scalar.pixels()))
                    << first << " " << row.name << " " << f;
            }
        }
    }
}

TEST(Filters, EachIsTheSameForAnyNumberOfThreads) {
    for (const FilterRow& row : filters()) {
        FieldOptions options = exact(std::string(row.name));
        options.flow.method = "horn-schunck";
        options.seeds.order = "age";
        options.threads = 1;
        const std::vector<Field> one = fields_of(options, 12, with_colour);
        options.threads = 4;
        const std::vector<Field> four = fields_of(options, 12, with_colour);
        for (std::size_t f = 0; f < one.size(); ++f) {
            ASSERT_TRUE(std::ranges::equal(one[f].scalar.pixels(), four[f].scalar.pixels())) << row.name << " " << f;
            ASSERT_EQ(one[f].seeds, four[f].seeds) << row.name << " " << f;
        }
    }
}

TEST(Filters, SmallestPictures) {
    for (const FilterRow& row : filters()) {
        for (const Size tiny : {Size{1, 1}, Size{3, 1}, Size{2, 9}}) {
            FieldOptions options;
            options.filter = row.name;
            options.threads = 1;
            int seen = 0;
            const FrameReader read = [&, next = 0]() mutable -> FrameJob {
                if (next == 3) return {};
                return [index = next++, tiny] {
                    return test::flat_frame(tiny, index, static_cast<std::uint8_t>(90 * index));
                };
            };
            compute_fields(read, black(tiny), options, [&](const SharedFrame&, Field&& field) {
                EXPECT_EQ(field.scalar.size(), tiny) << row.name;
                ++seen;
            });
            EXPECT_EQ(seen, 3);
        }
    }
}

TEST(FilterTable, EveryRowHasANameOfItsOwnAndHelp) {
    std::set<std::string_view> names;
    for (const FilterRow& row : filters()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_FALSE(row.help.empty());
    }
    EXPECT_TRUE(names.contains("difference"));
}

}  // namespace
}  // namespace vvr
