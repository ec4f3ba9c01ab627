#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/footage/input_files.h"
#include "core/footage/segments.h"
#include "core/footage/unseen.h"
#include "core/media/frame_gaps.h"
#include "core/media/frame_sampler.h"
#include "core/media/frame_source.h"
#include "core/media/live_source.h"
#include "core/media/video_reader.h"
#include "tests/support/errors.h"

namespace vvr {
namespace {

TEST(NaturalOrder, CountsAsPeopleDo) {
    EXPECT_TRUE(footage::natural_less("frame2.png", "frame10.png"));
    EXPECT_FALSE(footage::natural_less("frame10.png", "frame2.png"));
    EXPECT_TRUE(footage::natural_less("frame09", "frame10"));
    EXPECT_TRUE(footage::natural_less("a2b10", "a2b11"));
    EXPECT_TRUE(footage::natural_less("a", "a1"));
    EXPECT_TRUE(footage::natural_less("99999999999999999999998", "99999999999999999999999"));
}

TEST(NaturalOrder, IsStrict) {
    EXPECT_FALSE(footage::natural_less("frame1", "frame1"));
    EXPECT_NE(footage::natural_less("frame1", "frame01"), footage::natural_less("frame01", "frame1"));
}

TEST(FrameNumbers, LeaveOutWhatIsMissing) {
    const auto numbers = [](double rate, const std::vector<double>& times) {
        media::FrameNumbers number(rate);
        std::vector<std::int64_t> all;
        for (const double time : times) all.push_back(number(time));
        return all;
    };
    using Numbers = std::vector<std::int64_t>;
    EXPECT_EQ(numbers(10, {0, 0.1, 0.2, 0.3}), (Numbers{0, 1, 2, 3}));
    EXPECT_EQ(numbers(10, {0, 0.1, 60.1, 60.2}), (Numbers{0, 1, 601, 602}));
    EXPECT_EQ(numbers(10, {0, 0.1, 4.9, 5}), (Numbers{0, 1, 2, 3})) << "a short pause";
    EXPECT_EQ(numbers(0.5, {0, 2, 32, 34}), (Numbers{0, 1, 2, 3})) << "a pause at a low rate";
    EXPECT_EQ(numbers(10, {0, 6, 12, 18}), (Numbers{0, 1, 2, 3})) << "a header with another rate";
    EXPECT_EQ(numbers(0, {0, 0.1, 60}), (Numbers{0, 1, 2})) << "an unknown rate";
    EXPECT_EQ(numbers(10, {0, 0.1, 1e9}), (Numbers{0, 1, 2})) << "a wrong timestamp";
}

TEST(FrameGaps, FindWhatIsMissingHoweverShort) {
    const auto gaps = [](double rate, const std::vector<double>& times) {
        media::FrameGaps find(rate);
        std::vector<std::array<double, 3>> found;
        for (const double time : times) {
            if (const auto gap = find(time)) found.push_back({gap->begin, gap->end, static_cast<double>(gap->frames)});
        }
        return found;
    };
    using Gaps = std::vector<std::array<double, 3>>;
    EXPECT_EQ(gaps(10, {0, 0.1, 0.2, 0.3}), Gaps());
    EXPECT_EQ(gaps(10, {0, 0.1, 4.1, 4.2}), (Gaps{{0.1, 4.1, 39}}));
    EXPECT_EQ(gaps(10, {0, 0.1, 0.4, 0.5}), (Gaps{{0.1, 0.4, 2}}));
    EXPECT_EQ(gaps(10, {0, 0.1, 0.3, 0.4}), Gaps()) << "the rate may vary so much";
    EXPECT_EQ(gaps(0, {0, 0.1, 0.2, 3.2}), (Gaps{{0.2, 3.2, 29}})) << "an unknown rate";
    EXPECT_EQ(gaps(7.5, {0, 0.1, 0.2, 4.2}), (Gaps{{0.2, 4.2, 39}})) << "a rate that counts the gap";
    EXPECT_EQ(gaps(10, {0, 0.1, 1.1, 2.1, 3.1, 4.1}).size(), 2) << "a camera that slows down";
    EXPECT_FALSE(media::FrameGaps(10, true)(9)) << "before the first frame there is none";
    media::FrameGaps key_frames(10, true);
    key_frames(0);
    EXPECT_FALSE(key_frames(3)) << "frames at any times";
    EXPECT_TRUE(key_frames(9, true)->numbered);
}

TEST(Damage, IsListedByItsTime) {
    std::vector<media::Damage> list;
    add_damage(list, {1, 1.1, 2});
    add_damage(list, {1.5, 1.6, 3});
    add_damage(list, {7, 7.1, 1});
    ASSERT_EQ(list.size(), 2);
    EXPECT_EQ(list[0].packets, 5);
    EXPECT_DOUBLE_EQ(list[0].end, 1.6);
    for (int k = 0; k < 5000; ++k) add_damage(list, {100 + 10.0 * k, 101 + 10.0 * k, 1});
    EXPECT_EQ(list.size(), 1000);
    EXPECT_EQ(list.back().packets, 5000 - 997);
}

// As in tests/web/page_player.test.js, which asks the page's own function.
TEST(FileAt, IsTheFirstThatHasNotEnded) {
    const std::vector<media::SegmentPlace> files{{"a", 0, 10, 0}, {"b", 10, 20, 0}, {"c", 30, 35, 0}, {"d", 34, 40, 0}};
    std::string names;
    for (const double seconds : {-1.0, 0.0, 9.9, 9.999, 10.0, 25.0, 30.0, 34.5, 35.0, 99.0})
        names += footage::file_at(files, seconds).file->path;
    EXPECT_EQ(names, "aaabbcccdd");
    EXPECT_DOUBLE_EQ(footage::file_at(files, 12.5).offset, 2.5);
    EXPECT_DOUBLE_EQ(footage::file_at(files, 25).offset, 0) << "the beginning of the next";
    EXPECT_EQ(footage::file_at({}, 1).file, nullptr);
}

TEST(Unseen, IsToldInWords) {
    using Words = std::vector<std::string>;
    EXPECT_EQ(words_of(footage::Unseen()), Words());
    EXPECT_EQ(words_of(footage::Unseen{.masked = 0.004}), Words()) << "a clock in a corner";
    EXPECT_EQ(words_of(footage::Unseen{.masked = std::nullopt}), Words{"a part of the scene masked"});
    const footage::Unseen much{
        .masked = 0.5, .gaps = {{1, 5, 39}, {6, 60, 500, true}}, .damage = {{7, 8, 30}}, .damaged = 30, .dropped = 1};
    EXPECT_EQ(words_of(much),
              (Words{"50 % of the scene masked", "no frames for 4.0 s", "30 damaged packets", "1 frame dropped"}));
    EXPECT_EQ(words_of(footage::Unseen{.gaps = {{1, 1.4, 3}}}), Words()) << "a short gap is only listed";
}

TEST(StampClock, StartsAtTheFirstStamp) {
    media::StampClock clock(0.04);
    EXPECT_DOUBLE_EQ(clock(5.0), 0);
    EXPECT_DOUBLE_EQ(clock(5.5), 0.5);
    EXPECT_DOUBLE_EQ(clock(std::nullopt), 0.54);
}

TEST(StampClock, NeverRunsBackwards) {
    media::StampClock clock(0.04);
    clock(0.0);
    clock(1.0);
    EXPECT_DOUBLE_EQ(clock(0.9), 1.0);
    EXPECT_DOUBLE_EQ(clock(1.1), 1.1);
}

TEST(StampClock, GoesOnWhenTheCameraSetsItsClockBack) {
    media::StampClock clock(0.04);
    clock(1000.0);
    clock(1010.0);
    EXPECT_DOUBLE_EQ(clock(3.0), 10.04);
    EXPECT_DOUBLE_EQ(clock(4.0), 11.04);
}

TEST(StampClock, CountsFromTheFirstFrameWhenItHasNoStamp) {
    media::StampClock clock(0.5);
    EXPECT_DOUBLE_EQ(clock(std::nullopt), 0);
    EXPECT_DOUBLE_EQ(clock(7.0), 0.5);
    EXPECT_DOUBLE_EQ(clock(8.0), 1.5);
}

TEST(LiveClock, FollowsTheStampsOfOneConnection) {
    media::LiveClock clock(0.04);
    EXPECT_EQ(clock(100.0, 5), 0);
    EXPECT_NEAR(clock(100.04, 9), 0.04, 1e-9);  // late, and yet taken 40 ms after the other
    EXPECT_NEAR(clock(103.0, 9.01), 3.0, 1e-9);
    EXPECT_NEAR(clock(std::nullopt, 9.02), 3.04, 1e-9);
}

TEST(LiveClock, GoesByTheReadersClockWhereStampsSayNothing) {
    media::LiveClock clock(0.04);
    clock(100.0, 0);
    clock(100.04, 0.04);
    clock.restart();
    EXPECT_NEAR(clock(7.0, 12.04), 12.04, 1e-9);  // another connection, 12 s later
    EXPECT_NEAR(clock(7.04, 12.08), 12.08, 1e-9);
    EXPECT_NEAR(clock(2.0, 12.12), 12.12, 1e-9);   // the camera's clock went back
    EXPECT_NEAR(clock(5000.0, 12.2), 12.2, 1e-9);  // and far ahead
    EXPECT_NEAR(clock(5000.04, 12.24), 12.24, 1e-9);
    EXPECT_NEAR(clock(5000.08, 17.24), 12.28, 1e-9);  // a decoder's last frame, when the connection is given up
    clock.restart();
    EXPECT_NEAR(clock(1.0, 30.0), 30.0, 0.01);
}

TEST(LiveClock, KeepsTheHoleOfAFileThatIsReadAtOnce) {
    media::LiveClock clock(0.04, true);
    clock(100.0, 0);
    EXPECT_NEAR(clock(160.0, 0.001), 60, 1e-9);
    EXPECT_NEAR(clock(160.04, 0.002), 60.04, 1e-9);
    EXPECT_NEAR(clock(1e12, 0.003), 60.08, 1e-9);  // no clip is as long
    EXPECT_NEAR(clock(3.0, 0.004), 60.12, 1e-9);   // its camera's clock went back
}

TEST(LiveClock, GoesByTheArrivalWhereThereAreNoStamps) {
    media::LiveClock clock(0.04, false, true);
    EXPECT_EQ(clock(100.0, 3), 0);
    EXPECT_NEAR(clock(100.04, 3.1), 0.1, 1e-9);  // the stamps are made up
    EXPECT_NEAR(clock(100.08, 3.1), 0.101, 1e-9);
    EXPECT_NEAR(clock(100.12, 3.3), 0.3, 1e-9);
    clock.restart();
    EXPECT_NEAR(clock(std::nullopt, 23), 20, 1e-9);
}

TEST(LiveClock, NeverRunsBackwards) {
    media::LiveClock clock(0.04);
    double last = -1;
    for (const double stamp : {3.0, 3.04, 3.02, 3.08, -50.0, 1e9, 2.0, 2.04}) {
        const double time = clock(stamp, 0);  // all at once
        EXPECT_GT(time, last) << stamp;
        last = time;
    }
}

TEST(TimeSampler, KeepsAllOfAShortStream) {
    media::TimeSampler<int> sampler(10);
    for (int i = 0; i < 10; ++i) {
        if (sampler.wants(i)) sampler.keep(i, i);
    }
    EXPECT_EQ(sampler.take().size(), 10u);
}

TEST(TimeSampler, SpreadsOverAStreamOfAnyLength) {
    for (const int length : {11, 100, 795, 10'000}) {
        media::TimeSampler<int> sampler(64);
        for (int i = 0; i < length; ++i) {
            if (sampler.wants(i / 25.0)) sampler.keep(i / 25.0, i);
        }
        const auto kept = sampler.take();
        EXPECT_LE(kept.size(), 64u);
        EXPECT_GT(std::ssize(kept), std::min(length, 64) / 3);
        EXPECT_EQ(kept.front(), 0);
        EXPECT_GT(kept.back(), length * 0.9);
        // No hole is wider than three times the average.
        for (std::size_t i = 1; i < kept.size(); ++i) {
            EXPECT_LE((kept[i] - kept[i - 1]) * static_cast<int>(kept.size()), 3 * length + 64);
        }
    }
}

TEST(TimeSampler, StaysBoundedWhenTimeStandsStill) {
    media::TimeSampler<int> sampler(4);
    for (int i = 0; i < 100; ++i) {
        if (sampler.wants(0)) sampler.keep(0, i);
    }
    EXPECT_LE(sampler.take().size(), 4u);
}

TEST(FieldSize, IsAtMost384AndNeverLarger) {
    EXPECT_EQ(media::field_size_for({768, 576}, {0, 0}), (Size{384, 288}));
    EXPECT_EQ(media::field_size_for({1080, 1920}, {0, 0}), (Size{216, 384}));
    EXPECT_EQ(media::field_size_for({100, 50}, {0, 0}), (Size{100, 50}));
    EXPECT_EQ(media::field_size_for({1, 5000}, {0, 0}), (Size{1, 384}));
    EXPECT_EQ(media::field_size_for({1, 1}, {0, 0}), (Size{1, 1}));
    EXPECT_EQ(media::field_size_for({333, 211}, {-1, -1}), (Size{333, 211}));
    EXPECT_EQ(media::field_size_for({333, 211}, {1000, 3}), (Size{1000, 3}));
}

TEST(FieldSize, RefusesWhatCannotBe) {
    for (const auto& [asked, code] : {std::pair(Size{0, 100}, ErrorCode::option_value_out_of_range),
                                      {Size{-5, 100}, ErrorCode::option_value_out_of_range},
                                      {Size{100'000, 100'000}, ErrorCode::picture_too_large}}) {
        test::expect_error(code, [size = asked] { media::field_size_for({768, 576}, size); });
    }
}

}  // namespace
}  // namespace vvr
