#include "core/page/moments.h"

#include <gtest/gtest.h>

namespace vvr {
namespace {

constexpr Size field{40, 30};

/// Frames 0, 1, 2, ... at 10 per second, each of one grey.
class Frames final : public fields::FieldSource {
  public:
    explicit Frames(std::int64_t count) : count_(count) { info_.size = {80, 60}; }

    const media::VideoInfo& info() const override { return info_; }
    Size field_size() const override { return field; }
    std::int64_t expected_frames() const override { return 0; }
    fields::FieldSummary read(const fields::FieldNeeds&, const fields::FieldSink& sink) override {
        for (std::int64_t k = 0; k < count_; ++k) {
            auto frame = std::make_shared<media::Frame>();
            frame->index = k;
            frame->pts = 0.1 * static_cast<double>(k);
            frame->colour = Plane<Bgr>(field, Bgr{static_cast<std::uint8_t>(k % 250), 0, 0});
            fields::Field of_frame;
            of_frame.index = k;
            of_frame.pts = frame->pts;
            sink(frame, std::move(of_frame));
        }
        return {};
    }

  private:
    media::VideoInfo info_;
    std::int64_t count_;
};

TEST(RecentMoments, KeepTheEndOfAStreamAndNoMore) {
    Frames frames(5000);
    page::RecentMoments moments(frames.info().size, 400);
    frames.read({}, [&](const media::SharedFrame& frame, fields::Field&& one) { moments.add(*frame, one); });
    const page::Moments all = moments.since(0);
    ASSERT_EQ(all.times.size(), 1U);
    EXPECT_EQ(all.times[0].first, 4600);
    EXPECT_EQ(all.times[0].count, 400);
    EXPECT_NEAR(all.times[0].begin, 460, 1e-3);
    EXPECT_LE(all.stills.size(), 42U);
    EXPECT_GE(all.stills.size(), 38U);
    const page::Moments end = moments.since(4900);
    EXPECT_EQ(end.times[0].first, 4900);
    for (const page::Still& still : end.stills) {
        EXPECT_GE(still.frame, 4900);
        EXPECT_EQ(still.picture.at(0, 0)[0], still.frame % 250);
    }
    EXPECT_FALSE(moments.since(4999).stills.empty()) << "the last still there is, rather than none";
}

std::vector<page::Still> stills(std::int64_t step = 10) {
    std::vector<page::Still> stills;
    for (std::int64_t k = 0; k < 100; k += step)
        stills.push_back({k, 0.1 * static_cast<double>(k), Plane<Bgr>({80, 60})});
    return stills;
}

tracking::Event event_of(tracking::EventKind kind, std::int64_t first, std::int64_t last, glm::dvec2 place) {
    tracking::Event event;
    event.kind = kind;
    event.first = {first, 0.1 * static_cast<double>(first)};
    event.last = {last, 0.1 * static_cast<double>(last)};
    event.box = {0, 0, 6, 6};
    event.path = {{event.first, place}, {event.last, place}};
    return event;
}

TEST(TellingStill, IsOfWhatWasLeft) {
    const std::vector<page::Still> all = stills();
    const std::vector<tracking::Event> events{event_of(tracking::EventKind::moved, 0, 99, {5, 5}),
                                              event_of(tracking::EventKind::left, 60, 80, {20, 15}),
                                              event_of(tracking::EventKind::stood, 20, 50, {5, 5})};
    EXPECT_EQ(page::best_still(all, events)->frame, 70);
    EXPECT_EQ(page::best_still(all, std::vector{event_of(tracking::EventKind::taken, 60, 80, {20, 15})})->frame, 60)
        << "later stills lack it";
}

TEST(TellingStill, IsTheMiddleWhereNothingHappened) {
    const std::vector<page::Still> all = stills();
    EXPECT_EQ(page::best_still(all, {})->frame, 50);
    EXPECT_FALSE(page::best_still({}, {}));
}

TEST(ContactSheet, HasTheStillsOfEvents) {
    std::vector<page::Still> all = stills(1);
    all[62].picture.at(0, 0) = {{9, 9, 9}};
    const std::vector<tracking::Event> events{event_of(tracking::EventKind::moved, 10, 12, {5, 5}),
                                              event_of(tracking::EventKind::left, 60, 68, {20, 15}),
                                              event_of(tracking::EventKind::stood, 64, 70, {5, 5})};
    const auto sheet = page::contact_sheet(all, events);
    ASSERT_TRUE(sheet);
    ASSERT_EQ(sheet->seconds.size(), 3U + 11);
    EXPECT_NEAR(sheet->seconds[1], 1.1, 1e-9);
    EXPECT_NEAR(sheet->seconds[3], 6.0, 1e-9);
    EXPECT_EQ(sheet->picture.size().width, page::ContactSheet::columns * 80);
    EXPECT_EQ(sheet->picture.size().height, 2 * 60);
    EXPECT_GT(sheet->picture.at(5 * 80, 0)[0], 0) << "the sixth picture is not that of frame 62";
}

TEST(ContactSheet, IsSmall) {
    const std::vector<page::Still> all = stills(1);
    const std::vector<tracking::Event> whole{event_of(tracking::EventKind::moved, 0, 99, {5, 5})};
    const auto sheet = page::contact_sheet(all, whole);
    ASSERT_TRUE(sheet);
    EXPECT_EQ(sheet->seconds.size(), page::ContactSheet::most);
    EXPECT_TRUE(std::ranges::is_sorted(sheet->seconds));
    EXPECT_LT(sheet->seconds.front(), 0.3);
    EXPECT_GT(sheet->seconds.back(), 9.6);
    // Without events, and where none of them has a still of its own.
    EXPECT_EQ(page::contact_sheet(all, {})->seconds.size(), 1U);
    const std::vector<page::Still> two{all.front(), all.back()};
    const std::vector<tracking::Event> brief{event_of(tracking::EventKind::moved, 33, 36, {5, 5})};
    EXPECT_EQ(page::contact_sheet(two, brief)->seconds, std::vector<double>{0.0});
    EXPECT_FALSE(page::contact_sheet({}, brief));
}

}  // namespace
}  // namespace vvr
