#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/annotation/lettering.h"
#include "core/annotation/ruler.h"
#include "core/annotation/sheet.h"
#include "core/annotation/time_ticks.h"
#include "core/scene/scene.h"
#include "core/volume/brick.h"
#include "tests/support/fields.h"
#include "tests/support/zone.h"

namespace vvr {
namespace {

std::vector<std::string> texts(const std::vector<annotation::TimeTick>& ticks) {
    std::vector<std::string> result;
    for (const annotation::TimeTick& tick : ticks) result.push_back(tick.text);
    return result;
}

using Texts = std::vector<std::string>;

TEST(TimeTicks, AreRoundAndFew) {
    EXPECT_EQ(texts(annotation::time_ticks(0, 79.4, 9)),
              (Texts{"0:00", "0:10", "0:20", "0:30", "0:40", "0:50", "1:00", "1:10"}));
    EXPECT_EQ(texts(annotation::time_ticks(0.04, 1.2, 6)),
              (Texts{"0.2 s", "0.4 s", "0.6 s", "0.8 s", "1.0 s", "1.2 s"}));
    EXPECT_EQ(texts(annotation::time_ticks(0, 6.5 * 3600, 8)),
              (Texts{"0:00", "1:00:00", "2:00:00", "3:00:00", "4:00:00", "5:00:00", "6:00:00"}));
    for (const double length : {0.02, 0.3, 1.0, 7.0, 59.0, 600.0, 5000.0, 86400.0, 4e6, 9e9}) {
        for (const int most : {1, 3, 8, 11}) {
            const std::vector<annotation::TimeTick> ticks = annotation::time_ticks(3.3, 3.3 + length, most);
            EXPECT_LE(ticks.size(), static_cast<std::size_t>(most)) << length;
            for (const annotation::TimeTick& tick : ticks)
                EXPECT_TRUE(tick.seconds > 3.299 - length * 0.001 && tick.seconds < 3.31 + length * 1.001) << tick.text;
        }
    }
    EXPECT_GE(annotation::time_ticks(3.3, 10, 8).size(), 3U);
    EXPECT_TRUE(annotation::time_ticks(5, 5, 8).empty());
    EXPECT_TRUE(annotation::time_ticks(0, NAN, 8).empty());
}

TEST(TimeTicks, AreRoundOnTheClockOnTheWall) {
    const std::int64_t at = 1'795'248'017;  // 2026-11-21 08:00:17
    EXPECT_EQ(texts(annotation::time_ticks(0, 150, 4, at)), (Texts{"08:01", "08:02"}));
    EXPECT_EQ(annotation::time_ticks(0, 150, 4, at).front().seconds, 43);
    EXPECT_EQ(texts(annotation::time_ticks(0, 40, 5, at)), (Texts{"08:00:20", "08:00:30", "08:00:40", "08:00:50"}));
    EXPECT_EQ(texts(annotation::time_ticks(0, 0.9, 2, at)), (Texts{"08:00:17.00", "08:00:17.50"}));
    EXPECT_EQ(texts(annotation::time_ticks(0, 3 * 86400.0, 4, at)), (Texts{"11-22", "11-23", "11-24"}));
    EXPECT_EQ(annotation::format_interval_and_zone(0, 46, at), "2026-11-21 08:00:17 to 08:01:03 (as given)");
    EXPECT_EQ(annotation::format_interval_and_zone(0, 60000, at),
              "2026-11-21 08:00:17 to 2026-11-22 00:40:17 (as given)");
    EXPECT_EQ(annotation::format_interval_and_zone(0, 7.5), "0.0 s to 7.5 s");
    EXPECT_EQ(annotation::format_interval_and_zone(0, 7267), "0:00 to 2:01:07");
}

TEST(Text, IsMadePrintable) {
    EXPECT_EQ(image::printable("Tür \"1\" <b>\n"), "Tür \"1\" <b> ");
    EXPECT_EQ(image::printable("a\xFF\xC3z\xE2\x82"), "a??z??");
    EXPECT_EQ(image::printable("\xC0\x80 \xED\xA0\x80"), "?? ???") << "what only looks like UTF-8";
    EXPECT_EQ(image::printable(""), "");
}

TEST(Text, IsElidedByWholeCharacters) {
    const std::string name = "Überwachung-Tür-März.avi";
    EXPECT_EQ(annotation::elide(name, 20, 10'000), name);
    const std::string shorter = annotation::elide(name, 20, 120);
    ASSERT_TRUE(shorter.ends_with("…"));
    EXPECT_EQ(name.find(shorter.substr(0, shorter.size() - 3)), 0U);
    EXPECT_EQ(image::printable(shorter), shorter);
    EXPECT_LE(image::measure_text(shorter, 20)->width(), 120);
    EXPECT_EQ(annotation::elide(name, 20, 3), "");
}

TEST(Text, CoversThePixelsThatItSays) {
    image::Picture picture{Plane<image::Rgba>({200, 60}, image::Rgba{1, 1, 1, 1})};
    const annotation::Label label = annotation::make_label("gÄ 0:10", 24, 30, 40, {0, 0, 0, 1});
    annotation::Lettering lettering;
    ASSERT_TRUE(lettering.add(label, {0, 0, 200, 60}, 0));
    annotation::draw(picture, lettering);
    PixelBox ink{200, 60, 0, 0};
    for (int j = 0; j < 60; ++j) {
        for (int i = 0; i < 200; ++i) {
            if (picture.pixels.at(i, j)[0] > 0.9F) continue;
            ink = {std::min(ink.left, i), std::min(ink.top, j), std::max(ink.right, i + 1),
                   std::max(ink.bottom, j + 1)};
        }
    }
    EXPECT_TRUE(label.box.contains(ink)) << ink.left << " " << ink.top << " " << ink.right << " " << ink.bottom;
    EXPECT_NEAR(ink.width(), label.box.width(), 3);
    EXPECT_NEAR(ink.height(), label.box.height(), 3);
    EXPECT_EQ(label.box.left, 30);
}

TEST(Lettering, TakesNothingThatMeetsAnotherOrLeaves) {
    annotation::Lettering lettering;
    const PixelBox area{0, 0, 300, 100};
    EXPECT_TRUE(lettering.add(annotation::make_label("first", 20, 10, 50, {}), area, 4));
    EXPECT_FALSE(lettering.add(annotation::make_label("second", 20, 30, 55, {}), area, 4));
    EXPECT_FALSE(lettering.add(annotation::make_label("third", 20, 280, 50, {}), area, 4));
    EXPECT_TRUE(lettering.add(annotation::make_label("fourth", 20, 150, 50, {}), area, 4));
    EXPECT_EQ(lettering.labels.size(), 2U);
}

volume::Volume clip_of(int frames) {
    return test::even_volume({32, 24}, frames);
}

TEST(BusyTime, LeavesLittleRoomToWhereNothingMoves) {
    for (const std::int64_t capacity : {6000, 800, 100}) {
        const volume::Volume volume = test::day_with_pauses(capacity);
        const std::vector<annotation::TimeBreak> breaks = annotation::time_breaks(volume, 9);
        ASSERT_EQ(breaks.size(), 3U) << capacity;
        for (const annotation::TimeBreak& gap : breaks) EXPECT_NEAR(gap.seconds, 3600, 40) << capacity;
        EXPECT_EQ(annotation::time_breaks(volume, 1).size(), 1U);
        for (int k = 0; k < 3; ++k) {
            const double begin = 3780 * k + 3600;
            const double room = volume.t_of_seconds(begin + 180) - volume.t_of_seconds(begin);
            EXPECT_GT(room, 0.22) << k << ": " << capacity;
        }
        // Numbers, times and places belong together.
        const scene::TimeTable times(volume);
        for (const double t : {0.1, 0.3, 0.45, 0.7, 0.9}) {
            const double slots = static_cast<double>(volume.layers() * times.frames_per_layer());
            const Moment at = times.at(t * slots);
            EXPECT_EQ(static_cast<double>(at.frame), std::round(at.seconds));
            EXPECT_NEAR(volume.t_of_seconds(at.seconds), t, 1.1 / static_cast<double>(volume.layers()));
            EXPECT_NEAR(volume.t_of_frame(static_cast<double>(at.frame)), t,
                        1.1 / static_cast<double>(volume.layers()));
        }
    }
    EXPECT_TRUE(annotation::time_breaks(clip_of(100), 9).empty());
}

TEST(BusyTime, TicksStandWhereSomethingMoves) {
    const volume::Volume volume = test::day_with_pauses(800);
    const std::vector<annotation::TimeTick> ticks = annotation::spread_ticks(volume, 9, 0);
    EXPECT_GE(ticks.size(), 6U);
    EXPECT_LE(ticks.size(), 12U);
    for (std::size_t i = 1; i < ticks.size(); ++i) {
        EXPECT_GT(volume.t_of_seconds(ticks[i].seconds) - volume.t_of_seconds(ticks[i - 1].seconds), 0.8 / 9 - 1e-9);
    }
    for (const volume::CompressedIdle& stretch : volume::compressed_stretches(volume)) {
        for (const annotation::TimeTick& tick : ticks) {
            const double t = volume.t_of_seconds(tick.seconds);
            EXPECT_FALSE(stretch.t_begin < t && t < stretch.t_end - 1e-9) << tick.text;
        }
    }
}

TEST(BusyTime, BricksAreCutByTheClock) {
    const volume::Volume volume = test::day_with_pauses(800);
    EXPECT_EQ(volume::cut_by_clock(volume, 3780, 0).size(), 3U);
    std::int64_t next = 0;
    for (const volume::Brick& brick : volume::cut_by_clock(volume, 3600, -90)) {
        EXPECT_EQ(brick.first, next);
        next += brick.count;
    }
    EXPECT_EQ(next, volume.layers());
    EXPECT_EQ(volume::cut_by_frames(volume, 3780).size(), 3U);
}

TEST(BusyTime, IsUnevenOnlyWhereThatShows) {
    EXPECT_TRUE(annotation::is_uneven(test::day_with_pauses(800)));
    EXPECT_FALSE(annotation::is_uneven(clip_of(100)));
    volume::Volume busy({32, 24}, {.capacity = 100, .nonuniform = true});
    for (int i = 0; i < 100; ++i) busy.add({i, 0.1 * i, Plane<std::uint8_t>({32, 24}, 200), {}, {}}, {}, {}, true);
    busy.settle();
    EXPECT_FALSE(annotation::is_uneven(busy)) << "something moves all the time";
}

TEST(TimeTicks, GoOnAcrossSummerTimeAndMidnight) {
    const test::InZone berlin("Europe/Berlin");
    // From 2026-03-28 23:30 CET for four hours: at 2:00 clocks are put forward to 3:00.
    const Clock clock = local_clock(1774737000, 4 * 3600, ClockSource::file_name);
    EXPECT_EQ(texts(annotation::time_ticks(0, 4 * 3600, 4, clock)), (Texts{"00:00", "01:00", "03:00", "04:00"}));
    EXPECT_EQ(annotation::time_ticks(0, 4 * 3600, 4, clock)[2].seconds, 2.5 * 3600);
    EXPECT_EQ(annotation::format_interval_and_zone(0, 4 * 3600, clock),
              "2026-03-28 23:30:00 to 2026-03-29 04:30:00 (CET, UTC+1, then CEST, UTC+2; by file name)")
        << "what tells it";
    EXPECT_EQ(annotation::format_interval(0, 60, clock), "2026-03-28 23:30:00 to 23:31:00");
    EXPECT_EQ(clock.iso(0), "2026-03-28T23:30:00+01:00");
    EXPECT_EQ(clock.iso(2.5 * 3600), "2026-03-29T03:00:00+02:00");
    // In October the hour from 2:00 comes twice.
    const Clock back = local_clock(1792886400, 3 * 3600, ClockSource::file_name);
    EXPECT_EQ(texts(annotation::time_ticks(0, 3 * 3600, 4, back)), (Texts{"02:00", "02:00", "03:00", "04:00"}));
    EXPECT_EQ(Clock(1774737000).iso(1.5), "2026-03-28T22:30:01") << "of no zone";
}

TEST(TimeTicks, LengthsAreRound) {
    EXPECT_EQ(annotation::format_duration(7.4), "7 s");
    EXPECT_EQ(annotation::format_duration(420), "7 min");
    EXPECT_EQ(annotation::format_duration(12000), "3:20 h");
}

TEST(Gaps, AreWhereNoFrameCame) {
    const volume::Volume volume = test::volume_with_gap(30, 60);
    EXPECT_EQ(volume.missing(), 30);
    const std::vector<annotation::TimeGap> gaps = annotation::time_gaps(volume);
    ASSERT_EQ(gaps.size(), 1U);
    EXPECT_DOUBLE_EQ(gaps[0].t_begin, 0.3);
    EXPECT_DOUBLE_EQ(gaps[0].t_end, 0.6);
    EXPECT_TRUE(annotation::time_gaps(clip_of(100)).empty());

    // Layers that hold a frame are none of a gap.
    volume::Volume joined = test::volume_with_gap(31, 61, 50);
    ASSERT_EQ(annotation::time_gaps(joined).size(), 1U);
    EXPECT_NEAR(annotation::time_gaps(joined)[0].t_begin, 0.32, 1e-12);
    EXPECT_NEAR(annotation::time_gaps(joined)[0].t_end, 0.6, 1e-12);
    EXPECT_EQ(joined.missing(), 30);
    joined.drop_front(25);
    EXPECT_EQ(joined.missing(), 11);
}

TEST(Ruler, FindsMomentsBetweenTheLayers) {
    const volume::Volume volume = clip_of(100);
    EXPECT_NEAR(volume.t_of_seconds(0), 0, 1e-9);
    EXPECT_NEAR(volume.t_of_seconds(2), 0.5, 1e-9);
    EXPECT_NEAR(volume.t_of_seconds(2.02), 0.505, 1e-9);
    EXPECT_EQ(volume.t_of_seconds(-3), 0);
    EXPECT_LE(volume.t_of_seconds(99), 1);
    const volume::Volume joined = clip_of(2000);
    ASSERT_GT(joined.step(), 1);
    EXPECT_NEAR(joined.t_of_seconds(40), 0.5, 1e-3);
}

TEST(Sheet, HasNoTextWhereThereIsNoRoomForIt) {
    const annotation::Sheet sheet = annotation::arrange_sheet({160, 100}, {true, true, true});
    EXPECT_EQ(sheet.text, 0);
    EXPECT_EQ(sheet.volume.size(), (Size{160, 100}));
    EXPECT_EQ(annotation::arrange_sheet({1280, 800}, {}).volume.size(), (Size{1280, 800}))
        << "nor where none is asked for";
}

TEST(Ruler, HasTimesWhereACameraRecordsOnlyMotion) {
    // Twenty files of ten seconds, hours apart.
    volume::Volume volume({32, 24}, {.capacity = 400, .nonuniform = true});
    for (int file = 0; file < 20; ++file) {
        const int begin = 1 + 7919 * file;
        for (int i = begin; i < begin + 10; ++i)
            volume.add({i, 1.0 * i, Plane<std::uint8_t>({32, 24}, 200), {}, {}}, {}, {}, true);
        volume.add_gap(begin + 10, 7909, begin + 10, 1);
    }
    volume.settle();
    const std::vector<annotation::TimeTick> ticks = annotation::spread_ticks(volume, 9, 0);
    EXPECT_GE(ticks.size(), 6U);
    for (const annotation::TimeTick& tick : ticks) {
        const double since = std::fmod(tick.seconds - 1, 7919);
        EXPECT_LT(since, 10) << tick.text << " is in a gap";
    }
}

}  // namespace
}  // namespace vvr
