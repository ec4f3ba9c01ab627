#include <algorithm>
#include <tuple>

#include <gtest/gtest.h>

#include "core/footage/open_source.h"
#include "core/media/frame_choice.h"
#include "tests/support/errors.h"
#include "tests/unit/media/clips.h"

namespace vvr {
namespace {

using namespace test;

std::unique_ptr<media::FrameSource> open(const std::string& clip, std::string_view decode, std::int64_t layers = 0) {
    media::SourceOptions options;
    options.decode = decode;
    options.layers = layers;
    return footage::open_source(clip, options);
}

/// Expects some frames of a clip, numbered without gaps, each as it is among all.
void expect_part(const std::vector<media::Frame>& part, const std::vector<media::Frame>& all) {
    for (std::size_t i = 0; i < part.size(); ++i) {
        EXPECT_EQ(part[i].index, static_cast<std::int64_t>(i));
        const auto same = std::ranges::find_if(
            all, [&](const media::Frame& frame) { return std::abs(frame.pts - part[i].pts) < 1e-6; });
        ASSERT_NE(same, all.end());
        EXPECT_EQ(fingerprint({part[i]}), fingerprint({*same}));
    }
}

struct Encoding {
    std::string name;
    std::string arguments;
};

class WithBFrames : public testing::TestWithParam<Encoding> {};

TEST_P(WithBFrames, ReferenceLeavesOutWhatNothingRefersTo) {
    const TempFolder folder;
    const std::string clip = walkers_clip(folder, GetParam().name, GetParam().arguments);
    const std::vector<media::Frame> all = read_all(*open(clip, "all"));
    ASSERT_EQ(all.size(), 75U);
    const auto source = open(clip, "reference");
    const std::vector<media::Frame> part = read_all(*source);
    EXPECT_GT(part.size(), 15U);
    EXPECT_LT(part.size(), 60U);
    expect_part(part, all);
    EXPECT_EQ(source->damaged(), 0);
    EXPECT_EQ(source->info().decodes->name, "reference");
    EXPECT_EQ(source->info().frames, std::ssize(part));
    EXPECT_NEAR(source->info().rate, 25.0 * static_cast<double>(part.size()) / 75, 0.01);
    source->rewind();
    EXPECT_EQ(fingerprint(read_all(*source)), fingerprint(part));
    source->seek(part.back().pts);
    const auto late = source->next();
    ASSERT_TRUE(late);
    EXPECT_GT(late->index, 0);
    EXPECT_NEAR(late->pts, part[static_cast<std::size_t>(late->index)].pts, 1e-6);
}

TEST_P(WithBFrames, SamplesAreTheSameWithAndWithoutTheFramesBetween) {
    const TempFolder folder;
    const auto source = open(walkers_clip(folder, GetParam().name, GetParam().arguments), "all");
    for (const int count : {7, 31}) {
        const std::vector<media::Frame> samples = source->sample(count);
        EXPECT_GT(std::ssize(samples), count / 2);
        EXPECT_EQ(fingerprint(samples), fingerprint(source->FrameSource::sample(count)));
        EXPECT_EQ(read_all(*source).size(), 75U);
    }
}

constexpr auto avc = "-c:v libx264 -g 15 -bf 3 -b_strategy 0";
constexpr auto hevc = "-c:v libx265 -g 15 -x265-params log-level=none";

std::string name_of(const testing::TestParamInfo<Encoding>& test) {
    std::string name = test.param.name;
    std::ranges::replace(name, '.', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Video, WithBFrames, testing::Values(Encoding{"avc.mp4", avc}, Encoding{"hevc.ts", hevc}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Nightly, WithBFrames, testing::Values(Encoding{"avc.ts", avc}, Encoding{"hevc.mp4", hevc}),
                         name_of);

TEST(Decode, ReferenceIsEveryFrameWhereOthersMayReferToAny) {
    const TempFolder folder;
    for (const auto& [name, arguments] :
         {Encoding{"no_b.mp4", "-c:v libx264 -bf 0"}, Encoding{"old.avi", "-c:v mpeg4 -bf 2"}}) {
        const std::string clip = walkers_clip(folder, name, arguments);
        EXPECT_EQ(fingerprint(read_all(*open(clip, "reference"))), fingerprint(read_all(*open(clip, "all"))));
    }
}

TEST(Decode, KeyIsEveryKeyFrame) {
    const TempFolder folder;
    for (const auto& [name, arguments] :
         {Encoding{"key.mp4", "-c:v libx264 -g 15 -keyint_min 15 -sc_threshold 0 -bf 2"},
          Encoding{"open.mkv", "-c:v libx264 -g 15 -keyint_min 15 -sc_threshold 0 -x264-params open-gop=1"},
          Encoding{"old.avi", "-c:v mpeg4 -g 15 -sc_threshold 1000000000"}}) {
        const std::string clip = walkers_clip(folder, name, arguments);
        const auto source = open(clip, "key");
        const std::vector<media::Frame> part = read_all(*source);
        EXPECT_EQ(part.size(), 5U) << name;
        expect_part(part, read_all(*open(clip, "all")));
        EXPECT_EQ(source->damaged(), 0);
        EXPECT_EQ(source->info().frames, 5);
        EXPECT_EQ(source->info().decodes->name, "key");
    }
}

TEST(Decode, KeyFramesAreTheSameForAnyNumberOfThreads) {
    const TempFolder folder;
    const std::string clip = walkers_clip(folder, "key.mkv", "-c:v libx264 -g 5 -keyint_min 5 -sc_threshold 0 -qp 30");
    for (const std::string& name : {clip, spoiled(folder, clip)}) {
        const auto frames_of = [&](int threads) {
            media::SourceOptions options{.threads = threads};
            options.decode = "key";
            const auto source = footage::open_source(name, options);
            const std::vector<media::Frame> frames = read_all(*source);
            EXPECT_GT(frames.size(), 5U);
            const std::int64_t damaged = source->damaged();
            source->rewind();
            EXPECT_EQ(fingerprint(read_all(*source)), fingerprint(frames));
            source->seek(2);
            const auto late = source->next();
            EXPECT_TRUE(late);
            return std::tuple(fingerprint(frames), damaged, late ? late->index : -1);
        };
        const auto one = frames_of(1);
        for (const int threads : {2, 3, 8}) EXPECT_EQ(frames_of(threads), one) << name << ", " << threads << " threads";
        EXPECT_EQ(std::get<1>(one) > 0, name != clip);
    }
}

TEST(Decode, AutoIsReferenceWhereLayersAndFieldsAreCoarse) {
    const TempFolder folder;
    const std::string clip = walkers_clip(folder, "clip.mp4", "-c:v libx264 -preset ultrafast -bf 3 -s 1024x768");
    EXPECT_EQ(open(clip, "auto", 30)->info().decodes->name, "reference");
    EXPECT_EQ(open(clip, "auto", 70)->info().decodes->name, "all");
    EXPECT_EQ(open(clip, "auto")->info().decodes->name, "all");
    const std::string small = walkers_clip(folder, "small.mp4", "-c:v libx264 -bf 3");
    EXPECT_EQ(open(small, "auto", 30)->info().decodes->name, "all");
    const std::vector<media::Frame> part = read_all(*open(clip, "auto", 30));
    EXPECT_EQ(fingerprint(part), fingerprint(read_all(*open(clip, "reference"))));
}

TEST(Decode, OtherNamesAreRefused) {
    expect_error(ErrorCode::choice_unknown, [] { media::row_of(Name<media::FrameChoiceRow>{"keys"}); },
                 {"decode", "keys", "key"});
}

}  // namespace
}  // namespace vvr
