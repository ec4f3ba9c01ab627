#include "core/media/stamp_mender.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace vvr {
namespace {

using media::StampMender;

constexpr double tick = 0.001;
constexpr std::int64_t usual = 100;

/// Timestamps of frames from 0 on.
std::vector<std::int64_t> stamps_of(const std::vector<std::int64_t>& steps) {
    std::vector<std::int64_t> stamps{0};
    for (const std::int64_t step : steps) stamps.push_back(stamps.back() + step);
    return stamps;
}

std::vector<std::int64_t> times(int count, std::int64_t step) {
    return std::vector<std::int64_t>(static_cast<std::size_t>(count), step);
}

std::vector<std::int64_t> joined(const std::vector<std::vector<std::int64_t>>& parts) {
    std::vector<std::int64_t> all;
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

struct Mended {
    std::vector<std::int64_t> stamps;
    media::MendedFrames found;
};

/// \param stated ticks between frames, by the container
Mended mend(const std::vector<std::int64_t>& stamps, std::int64_t stated = usual) {
    StampMender mender(0, tick, static_cast<double>(stated));
    Mended mended;
    std::size_t next = 0;
    const auto read = [&](AVPacket& packet) {
        if (next == stamps.size()) return false;
        packet.dts = packet.pts = stamps[next++];
        return true;
    };
    for (const auto packet = media::av::make_packet(); mender.read(*packet, read);) {
        EXPECT_EQ(packet->pts, packet->dts);
        mended.stamps.push_back(packet->dts);
    }
    mended.found = mender.mended();
    return mended;
}

TEST(StampMender, GivesFramesATickApartTheUsualDistance) {
    const Mended mended = mend(stamps_of(joined({times(30, usual), times(60, 1), times(30, usual)})));
    EXPECT_EQ(mended.stamps, stamps_of(times(120, usual)));
    EXPECT_EQ(mended.found.frames, 60);
    EXPECT_DOUBLE_EQ(mended.found.from, 3.1);
    ASSERT_EQ(mended.found.intervals.size(), 1U);
    EXPECT_NEAR(mended.found.intervals.front().begin, 3, 1e-6);
    EXPECT_NEAR(mended.found.intervals.front().end, 9, 1e-6);
}

TEST(StampMender, PutsFramesThatCameLateIntoTheGapBeforeThem) {
    // 40 frames of 4 s come at once, and the next one at its time.
    const std::vector<std::int64_t> late{4000};
    const Mended mended =
        mend(stamps_of(joined({times(30, usual), late, times(39, 1), {usual - 39}, times(30, usual)})));
    EXPECT_EQ(mended.stamps.back(), 30 * usual + 4000 + usual + 30 * usual);
    EXPECT_EQ(mended.stamps[31], 31 * usual);
    EXPECT_EQ(mended.stamps[69], 69 * usual);
}

TEST(StampMender, LeavesTheGapThatLateFramesDoNotFill) {
    const Mended mended = mend(stamps_of(joined({times(30, usual), {60'000}, times(39, 1), times(30, usual)})));
    EXPECT_EQ(mended.stamps[69], 69 * usual);
    EXPECT_EQ(mended.stamps.back(), 30 * usual + 60'000 + 39 + 30 * usual);
}

TEST(StampMender, ChangesNothingElse) {
    const auto expect_same = [](const std::vector<std::int64_t>& steps, std::int64_t stated) {
        const Mended mended = mend(stamps_of(steps), stated);
        EXPECT_EQ(mended.stamps, stamps_of(steps));
        EXPECT_EQ(mended.found.frames, 0);
    };
    expect_same(joined({times(30, usual), times(20, 1), times(30, usual)}), usual);      // too few
    expect_same(joined({times(9, 20'000), times(200, usual), times(9, 20'000)}), 1700);  // a smart codec
    expect_same(joined({times(30, usual), {3'600'000}, times(30, usual)}), usual);
    expect_same(times(300, 1), 1);  // a camera of 1000 frames per second
}

}  // namespace
}  // namespace vvr
