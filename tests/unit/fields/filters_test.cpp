#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/fields/filter.h"
#include "core/fields/planes.h"
#include "tests/unit/fields/pictures.h"

namespace vvr {
namespace {

constexpr Size frame_size{64, 48};

/// A bright square that walks to the right by four pixels per frame, over a texture.
media::Frame walker(std::int64_t index) {
    media::Frame frame = test::texture_frame(frame_size, 0, 0, 0);
    frame.index = index;
    frame.pts = static_cast<double>(index) / 25;
    for (std::uint8_t& p : frame.grey.pixels()) p = static_cast<std::uint8_t>(30 + p / 4);
    const int left = static_cast<int>(4 * index);
    fill(frame.grey, {left, 16, left + 12, 32}, 220);
    return frame;
}

media::Frame with_colour(std::int64_t index) {
    media::Frame frame = walker(index);
    frame.colour = Plane<Bgr>(frame_size);
    std::ranges::transform(frame.grey.pixels(), frame.colour.pixels().begin(), [](std::uint8_t g) {
        return Bgr{g, g, g};
    });
    return frame;
}

std::vector<fields::Field> fields_of(const fields::FieldOptions& options, int count,
                                     media::Frame (*make)(std::int64_t) = walker) {
    return test::fields_of(test::frames_of(count, make), test::scene_of(make(1000)), options);
}

/// Without whatever would change a pixel for its neighbours' sake.
fields::FieldOptions exact(const std::string& filter) {
    fields::FieldOptions options{.filter = filter, .smooth = 0, .min_area = 0, .illumination = "none"};
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
    EXPECT_EQ(std::ranges::count(scalar.pixels(), 0), frame_size.width * frame_size.height - 12 * 16);
}

TEST(Filters, BandsTellWhatBecameOfAPixel) {
    const std::vector<fields::Field> fields = fields_of(exact("bands"), 4);
    const Plane<std::uint8_t>& first = fields[0].scalar;
    EXPECT_EQ(std::ranges::count(first.pixels(), static_cast<int>(fields::Band::newly_covered)), 12 * 16)
        << "before was nothing";
    const Plane<std::uint8_t>& scalar = fields[3].scalar;
    EXPECT_EQ(scalar.at(5, 20), static_cast<int>(fields::Band::background));
    EXPECT_EQ(scalar.at(9, 20), static_cast<int>(fields::Band::uncovered));
    EXPECT_EQ(scalar.at(15, 20), static_cast<int>(fields::Band::still_covered));
    EXPECT_EQ(scalar.at(21, 20), static_cast<int>(fields::Band::newly_covered));
    EXPECT_EQ(std::ranges::count(scalar.pixels(), static_cast<int>(fields::Band::uncovered)), 4 * 16);
    EXPECT_EQ(std::ranges::count(scalar.pixels(), static_cast<int>(fields::Band::still_covered)), 8 * 16);
    EXPECT_EQ(std::ranges::count(scalar.pixels(), static_cast<int>(fields::Band::newly_covered)), 4 * 16);
}

TEST(Filters, SignedTellsDarkerFromBrighter) {
    // A dark square and a bright one on grey.
    const media::Frame empty = test::flat_frame(frame_size, 0, 100);
    const auto make = [&](std::int64_t) {
        media::Frame frame = empty;
        fill(frame.grey, {0, 0, 8, frame_size.height}, 60);
        fill(frame.grey, {8, 0, 16, frame_size.height}, 160);
        return frame;
    };
    const Plane<std::uint8_t> scalar =
        test::fields_of(test::frames_of(1, make), test::scene_of(empty), exact("signed"))[0].scalar;
    EXPECT_EQ(scalar.at(3, 20), 128 - 40);
    EXPECT_EQ(scalar.at(12, 20), 128 + 60);
    EXPECT_EQ(scalar.at(30, 20), 0);
}

TEST(Values, JoinByTheirKind) {
    const auto bands = [](fields::Band a, fields::Band b) {
        return static_cast<fields::Band>(
            fields::joined(fields::Values::band, static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)));
    };
    using enum fields::Band;
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
    EXPECT_EQ(fields::joined(fields::Values::strength, 20, 90), 90);
    EXPECT_EQ(fields::joined(fields::Values::sign, 20, 200), 20) << "farther from the middle";
    EXPECT_EQ(fields::joined(fields::Values::sign, 120, 200), 200);
    EXPECT_EQ(fields::joined(fields::Values::sign, 0, 127), 127);
    EXPECT_EQ(fields::joined(fields::Values::sign, 127, 0), 127);
}

TEST(Norms, SayWhatDiffers) {
    const auto of = [](const Bgr& colour) {
        const auto grey = static_cast<std::uint8_t>((colour[0] + colour[1] + colour[2]) / 3);
        return fields::Planes{Plane<std::uint8_t>({1, 1}, grey), Plane<Bgr>({1, 1}, colour)};
    };
    const auto differ = [&](std::string_view norm, const Bgr& a, const Bgr& b) {
        return static_cast<int>(Choice<fields::NormRow>(norm)->difference(of(a), of(b)).at(0, 0));
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
    const fields::Planes grey{Plane<std::uint8_t>({1, 1}), {}};
    EXPECT_THROW(fields::norm_for(*Choice<fields::NormRow>("hue"), grey), Error);
    EXPECT_NO_THROW(fields::norm_for(*Choice<fields::NormRow>("luminance"), grey));
    EXPECT_THROW(Choice<fields::NormRow>("loudness"), Error);
}

TEST(Filters, TemporalShowsWhatChangedSinceTheFrameBefore) {
    const std::vector<fields::Field> fields = fields_of(exact("temporal"), 4);
    EXPECT_EQ(test::lit(fields[0].scalar), 0);
    const Plane<std::uint8_t>& scalar = fields[3].scalar;
    EXPECT_EQ(test::lit(scalar), 2 * 4 * 16);
    EXPECT_EQ(scalar.at(9, 20), 255);
    EXPECT_EQ(scalar.at(15, 20), 0);
    EXPECT_EQ(scalar.at(21, 20), 255);
}

TEST(Filters, EdgesAreSteepPlaces) {
    const fields::FieldOptions options = exact("edges");
    const Plane<std::uint8_t> scalar = fields_of(options, 4)[3].scalar;
    EXPECT_GT(scalar.at(12, 24), 50);
    EXPECT_EQ(scalar.at(18, 24), 0) << "inside the square all is even";
    const auto step = [](std::int64_t) {
        return media::Frame{0, 0, test::grey_plane({8, 8}, [](int i, int) { return i < 4 ? 0 : 255; }), {}};
    };
    const fields::EmptyScene black = test::scene_of(test::flat_frame({8, 8}, 0, 0));
    const Plane<std::uint8_t> edge = test::fields_of(test::frames_of(1, step), black, options)[0].scalar;
    EXPECT_EQ(edge.at(3, 4), 255) << "black beside white";
    EXPECT_EQ(edge.at(4, 4), 255);
    EXPECT_EQ(edge.at(1, 4), 0);
}

TEST(Filters, LuminanceIsTheVideo) {
    const Plane<std::uint8_t> scalar = fields_of(exact("luminance"), 4)[3].scalar;
    EXPECT_TRUE(test::same(scalar, walker(3).grey));
}

TEST(Filters, FlowIsItsMagnitude) {
    fields::FieldOptions options = exact("flow");
    EXPECT_EQ(test::lit(fields_of(options, 3)[1].scalar), 0) << "without a flow method there is none to show";
    options.flow.method = "horn-schunck";
    options.flow.every = 1000;
    options.threshold = 0;
    const auto moving = [](std::int64_t index) { return test::texture_frame({96, 80}, index, 3, 0); };
    const fields::EmptyScene black = test::scene_of(test::flat_frame({96, 80}, 0, 0));
    const std::vector<fields::Field> fields = test::fields_of(test::frames_of(3, moving), black, options);
    EXPECT_NEAR(fields[1].scalar.at(48, 40), 24 * 3, 4);
    EXPECT_FALSE(fields[0].seeds.empty());
    EXPECT_TRUE(fields[1].seeds.empty()) << "flow was not asked for there, only needed";
}

TEST(Filters, BackgroundModelsLearnTheScene) {
    for (const char* const name : {"mog2", "knn"}) {
        for (const auto make : {walker, with_colour}) {
            const std::vector<fields::Field> fields = fields_of(exact(name), 14, make);
            const Plane<std::uint8_t>& scalar = fields[10].scalar;
            EXPECT_EQ(scalar.at(45, 24), 255) << name;
            EXPECT_EQ(scalar.at(5, 5), 0) << name;
            EXPECT_EQ(scalar.at(60, 24), 0) << name;
        }
    }
}

/// What a background model says of frames of noise, each given to it by `run`.
template <class Run>
std::vector<Plane<std::uint8_t>> seen_by(const fields::FilterRow& row, const Run& run) {
    const fields::Filter filter = row.make(exact(std::string(row.name)));
    std::mt19937 random(7);
    std::vector<Plane<std::uint8_t>> masks;
    for (int i = 0; i < 30; ++i) {
        media::Frame frame = test::flat_frame(frame_size, i, 90);
        for (std::uint8_t& p : frame.grey.pixels()) p = static_cast<std::uint8_t>(60 + random() % 80);
        const fields::Planes smooth{frame.grey, {}};
        const Plane<std::uint8_t> none(frame_size, 0);
        run([&] { masks.push_back(filter({frame, smooth, nullptr, none, nullptr, none, {}})); });
    }
    return masks;
}

TEST(Filters, BackgroundModelsSeeTheSameOnAnyThread) {
    for (const char* const name : {"mog2", "knn"}) {
        const fields::FilterRow& row = *Choice<fields::FilterRow>(name);
        const auto here = seen_by(row, [](const auto& work) { work(); });
        const auto elsewhere = seen_by(row, [](const auto& work) { std::thread(work).join(); });
        for (std::size_t i = 0; i < here.size(); ++i) {
            EXPECT_TRUE(test::same(here[i], elsewhere[i])) << name << ", frame " << i;
        }
    }
}

/// All filters but the one that reads its values from files.
std::vector<fields::FilterRow> computed_filters() {
    std::vector<fields::FilterRow> computed;
    std::ranges::copy_if(fields::filters(), std::back_inserter(computed),
                         [](const fields::FilterRow& row) { return !row.traits.given; });
    return computed;
}

TEST(Filters, ThresholdRegionAndAreaHoldForAll) {
    for (const fields::FilterRow& row : computed_filters()) {
        fields::FieldOptions options = exact(std::string(row.name));
        options.threshold = 255;
        fields::EmptyScene scene = test::scene_of(walker(1000));
        scene.region = Plane<std::uint8_t>(frame_size, 255);
        fill(scene.region, {0, 0, frame_size.width, 24}, 0);
        for (const fields::Field& field : test::fields_of(test::frames_of(8, walker), scene, options)) {
            for (int j = 0; j < 24; ++j)
                ASSERT_EQ(std::ranges::count(field.scalar.row(j), 0), frame_size.width) << row.name;
            for (const int p : field.scalar.pixels()) {
                ASSERT_TRUE(p == 0 || p == 255 || row.traits.values != fields::Values::strength)
                    << row.name << " " << p;
            }
        }
    }
}

TEST(Filters, ASecondOneGivesWhatItGivesAlone) {
    for (const fields::FilterRow& row : computed_filters()) {
        for (const char* const first : {"difference", "luminance", "mog2"}) {
            fields::FieldOptions options = exact(std::string(row.name));
            options.flow.method = "horn-schunck";
            const std::vector<fields::Field> alone = fields_of(options, 6, with_colour);
            options.filter = first;
            const std::vector<fields::Field> without = fields_of(options, 6, with_colour);
            options.second = &row;
            const std::vector<fields::Field> both = fields_of(options, 6, with_colour);
            for (std::size_t f = 0; f < both.size(); ++f) {
                SCOPED_TRACE(testing::Message() << first << " " << row.name << " " << f);
                ASSERT_TRUE(test::same(both[f].second, alone[f].scalar));
                ASSERT_TRUE(test::same(both[f].scalar, without[f].scalar));
            }
        }
    }
}

TEST(Filters, EachIsTheSameForAnyNumberOfThreads) {
    for (const fields::FilterRow& row : computed_filters()) {
        fields::FieldOptions options = exact(std::string(row.name));
        options.flow.method = "horn-schunck";
        options.seeds.order = "age";
        options.threads = 1;
        const std::vector<fields::Field> one = fields_of(options, 12, with_colour);
        options.threads = 4;
        const std::vector<fields::Field> four = fields_of(options, 12, with_colour);
        for (std::size_t f = 0; f < one.size(); ++f) {
            ASSERT_TRUE(test::same(one[f].scalar, four[f].scalar)) << row.name << " " << f;
            ASSERT_EQ(one[f].seeds, four[f].seeds) << row.name << " " << f;
        }
    }
}

TEST(Filters, SmallestPictures) {
    for (const fields::FilterRow& row : computed_filters()) {
        for (const Size tiny : {Size{1, 1}, Size{3, 1}, Size{2, 9}}) {
            fields::FieldOptions options{.filter = row.name, .threads = 1};
            const auto make = [tiny](std::int64_t index) {
                return test::flat_frame(tiny, index, static_cast<std::uint8_t>(90 * index));
            };
            const auto fields = test::fields_of(test::frames_of(3, make), test::scene_of(make(0)), options);
            ASSERT_EQ(fields.size(), 3U);
            for (const fields::Field& field : fields) EXPECT_EQ(field.scalar.size(), tiny) << row.name;
        }
    }
}

TEST(FilterTable, EveryRowHasANameOfItsOwnAndHelp) {
    std::set<std::string_view> names;
    for (const fields::FilterRow& row : fields::filters()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_FALSE(row.help.empty());
    }
    EXPECT_TRUE(names.contains("difference"));
}

}  // namespace
}  // namespace vvr
