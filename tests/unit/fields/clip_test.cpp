#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/fields/field_source.h"
#include "core/footage/open_source.h"
#include "tests/support/errors.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/fields/pictures.h"

namespace vvr {
namespace {

/// A folder of numbered pictures: a dark scene through which a bright square walks.
class Clip : public testing::Test {
  protected:
    static constexpr Size size{64, 48};
    static constexpr int count = 12;

    Clip() {
        std::filesystem::create_directory(folder_ / "clip");
        for (int f = 0; f < count; ++f) {
            write("clip/" + std::to_string(1000 + f) + ".pgm",
                  [&](int i, int j) { return walker(f, i, j) ? 200 : 50; });
        }
        write("empty.pgm", [](int, int) { return 50; });
        write("full.pgm", [](int, int) { return 200; });
    }

    static bool walker(int frame, int i, int j) { return i >= 5 * frame && i < 5 * frame + 8 && j >= 16 && j < 32; }

    std::string path(const std::string& name) const { return folder_ / name; }

    fields::FieldSummary run(const fields::FieldOptions& options, const fields::FieldSink& sink) const {
        return fields::compute_fields(*footage::open_source(path("clip")), options, sink);
    }

    std::vector<fields::Field> fields_of(const fields::FieldOptions& options) const {
        std::vector<fields::Field> fields;
        run(options, [&](const media::SharedFrame&, fields::Field&& field) { fields.push_back(std::move(field)); });
        return fields;
    }

  private:
    template <class Function>
    void write(const std::string& name, Function value) const {
        const Plane<std::uint8_t> plane = test::grey_plane(size, value);
        std::ofstream file(folder_ / name, std::ios::binary);
        file << "P5\n" << size.width << " " << size.height << "\n255\n";
        file.write(reinterpret_cast<const char*>(plane.pixels().data()), std::ssize(plane.pixels()));
    }

    test::TempFolder folder_;
};

TEST_F(Clip, MedianReferenceIsTheEmptyScene) {
    const fields::FieldSummary summary =
        run({.threads = 2}, [&](const media::SharedFrame& frame, fields::Field&& field) {
            const auto f = static_cast<int>(frame->index);
            EXPECT_NE(field.scalar.at(5 * f + 2, 24), 0) << "the walker in frame " << f;
            EXPECT_EQ(field.scalar.at((5 * f + 30) % 64, 24), 0) << "where it isn't in frame " << f;
        });
    EXPECT_EQ(summary.frames, count);
    EXPECT_EQ(summary.damaged, 0);
    for (const int p : summary.reference.grey.pixels()) ASSERT_NEAR(p, 50, 1);
}

/// A camera that changes to infrared: first orange and blue stripes, then broader grey ones. A walker goes through
/// both.
class Dusk : public testing::Test {
  protected:
    static constexpr Size size{64, 48};
    static constexpr int count = 24;

    static Bgr by_day(int i, int) { return i / 4 % 2 == 0 ? Bgr{40, 110, 190} : Bgr{170, 90, 60}; }
    static Bgr by_night(int i, int) { return i / 10 % 2 == 0 ? Bgr{60, 60, 60} : Bgr{130, 130, 130}; }
    static Bgr covered(int, int) { return {5, 5, 5}; }

    static int walker(int frame) { return 4 * (frame % 14); }

    /// \param last the scene from the frame `dusk` on
    /// \param first the scene until then
    fields::FieldSummary run(int dusk, Bgr (*last)(int, int), const fields::FieldSink& sink,
                             const std::string& illumination = "global", Bgr (*first)(int, int) = by_day) const {
        std::filesystem::create_directory(folder_ / "clip");
        for (int f = 0; f < count; ++f) {
            std::ofstream file(folder_ / ("clip/" + std::to_string(1000 + f) + ".ppm"), std::ios::binary);
            file << "P6\n" << size.width << " " << size.height << "\n255\n";
            for (int j = 0; j < size.height; ++j) {
                for (int i = 0; i < size.width; ++i) {
                    const bool somebody = i >= walker(f) && i < walker(f) + 8 && j >= 16 && j < 28;
                    const Bgr pixel = somebody ? Bgr{250, 250, 250} : (f < dusk ? first : last)(i, j);
                    for (const std::size_t channel : {2U, 1U, 0U}) file.put(static_cast<char>(pixel[channel]));
                }
            }
        }
        media::SourceOptions in_colour;
        in_colour.colour = true;
        const fields::FieldOptions options{.illumination = illumination, .threads = 2};
        return fields::compute_fields(*footage::open_source(folder_ / "clip", in_colour), options, sink);
    }

  private:
    test::TempFolder folder_;
};

TEST_F(Dusk, EachModeHasItsEmptyScene) {
    const fields::FieldSummary summary = run(14, by_night, [&](const media::SharedFrame& frame, fields::Field&& field) {
        const auto f = static_cast<int>(frame->index);
        EXPECT_EQ(field.view, f >= 14 ? 1 : 0) << f;
        EXPECT_NE(field.scalar.at(walker(f) + 4, 24), 0) << f;
        EXPECT_EQ(field.scalar.at((walker(f) + 30) % 64, 24), 0) << f;
    });
    ASSERT_EQ(summary.reference.others.size(), 1);
    EXPECT_TRUE(summary.reference.others.front().infrared);
    EXPECT_NEAR(summary.reference.colour.at(1, 2)[2], 190, 2);
    EXPECT_NEAR(summary.reference.others.front().colour.at(1, 2)[2], 60, 2);
    const auto frames = [](const media::SharedFrame&, const fields::Field& field) { EXPECT_EQ(field.view, 0); };
    EXPECT_TRUE(run(14, by_night, frames, "none").reference.others.empty());
}

TEST_F(Dusk, FewFramesAreNoMode) {
    const auto frames = [](const media::SharedFrame&, const fields::Field& field) { EXPECT_EQ(field.view, 0); };
    EXPECT_TRUE(run(count - 2, by_night, frames).reference.others.empty());
    EXPECT_TRUE(run(2, by_night, frames).reference.others.empty());
}

TEST_F(Dusk, AColouredCarIsNoMode) {
    const auto car = [](int i, int j) { return i < 40 && j > 20 ? Bgr{30, 40, 200} : by_night(i, j); };
    const fields::FieldSummary summary = run(
        14, car, [](const auto&, const auto&) {}, "global", by_night);
    EXPECT_TRUE(summary.reference.others.empty());
}

TEST_F(Dusk, ACoveredCameraIsNotInInfrared) {
    const fields::FieldSummary summary =
        run(14, covered, [&](const media::SharedFrame& frame, const fields::Field& field) {
            EXPECT_EQ(field.view, 0);
            EXPECT_TRUE(frame->index < 14 || frame->index == count - 1) << "of the others nobody sees anything";
            if (frame->index < 14) return;
            EXPECT_EQ(test::lit(field.scalar), 0);
            EXPECT_EQ(field.before, condition::Kind::blank);
        });
    EXPECT_TRUE(summary.reference.others.empty());
}

TEST_F(Clip, DecodedPicturesAreThereOnlyInTheSink) {
    std::vector<media::SharedFrame> kept;
    run({.threads = 2, .full_size = true}, [&](const media::SharedFrame& frame, fields::Field&&) {
        EXPECT_FALSE(frame->full_size.picture.expired()) << "frame " << frame->index;
        for (const media::SharedFrame& earlier : kept) EXPECT_TRUE(earlier->full_size.picture.expired());
        kept.push_back(frame);
    });
    EXPECT_EQ(kept.size(), count);
    EXPECT_TRUE(kept.back()->full_size.picture.expired());
    run({.threads = 2}, [&](const media::SharedFrame& frame, fields::Field&&) {
        EXPECT_TRUE(frame->full_size.picture.expired()) << "nobody has asked for it";
    });
}

TEST_F(Clip, ReferenceFromAPicture) {
    fields::FieldOptions options{.reference = path("full.pgm"), .illumination = "none", .threads = 2};
    for (const fields::Field& field : fields_of(options)) EXPECT_GT(field.scalar.at(63, 2), 0);
    options.reference = path("empty.pgm");
    for (const fields::Field& field : fields_of(options)) EXPECT_EQ(field.scalar.at(63, 2), 0);
}

TEST_F(Clip, FourPartsGiveWhatTheWholeGives) {
    for (const char* const filter : {"difference", "temporal", "bands"}) {
        for (const char* const solver : {"pyramid", "jacobi"}) {
            fields::FieldOptions options{.filter = filter, .threads = 2};
            options.flow.solver = solver;
            options.seeds.grid = 4;
            const std::vector<fields::Field> whole = fields_of(options);
            std::vector<fields::Field> parts;
            const double seconds = count / 25.0;
            for (int k = 0; k < 4; ++k) {
                options.span.start = k * seconds / 4;
                options.span.end = (k + 1) * seconds / 4;
                const fields::FieldSummary summary =
                    run(options,
                        [&](const media::SharedFrame&, fields::Field&& field) { parts.push_back(std::move(field)); });
                EXPECT_EQ(summary.frames, count / 4);
            }
            ASSERT_EQ(parts.size(), whole.size());
            for (std::size_t f = 0; f < whole.size(); ++f) {
                ASSERT_EQ(parts[f].index, whole[f].index);
                ASSERT_TRUE(test::same(parts[f].scalar, whole[f].scalar)) << filter << f;
                ASSERT_TRUE(test::same(parts[f].flow.u, whole[f].flow.u)) << solver << f;
                ASSERT_EQ(parts[f].seeds, whole[f].seeds) << solver << f;
            }
            EXPECT_FALSE(whole[5].seeds.empty());
        }
    }
}

TEST_F(Clip, FlowOfAShortClipIsThatOfTheWholeFrame) {
    const auto still = [&](const char* area) {
        fields::FieldOptions options{.threads = 2};
        options.seeds.area = area;
        std::int64_t zeros = 0;
        for (const fields::Field& field : fields_of(options)) zeros += std::ranges::count(field.flow.u.pixels(), 0.F);
        return zeros;
    };
    EXPECT_EQ(still("object"), still("field"));
}

TEST_F(Clip, APartWithoutFramesIsAnError) {
    fields::FieldOptions options;
    options.span.start = 100;
    test::expect_error(ErrorCode::span_empty, [&] { fields_of(options); }, {"100 s"});
}

TEST_F(Clip, WhatIsMaskedIsNotLookedAt) {
    fields::FieldOptions options{.mask = "0,0 64,0 64,24 0,24", .threads = 2};
    for (const fields::Field& field : fields_of(options)) {
        for (int j = 0; j < 23; ++j) ASSERT_EQ(std::ranges::count(field.scalar.row(j), 0), size.width);
        EXPECT_NE(field.scalar.at(5 * static_cast<int>(field.index) + 3, 28), 0);
    }
    options.mask = path("full.pgm");  // all of it is bright
    for (const fields::Field& field : fields_of(options)) EXPECT_EQ(test::lit(field.scalar), 0);
}

TEST_F(Clip, ReferenceThatIsNotThere) {
    test::expect_error(ErrorCode::file_not_found, [&] { fields_of({.reference = path("nowhere.png")}); },
                       {"nowhere.png"});
}

}  // namespace
}  // namespace vvr
