#include <gtest/gtest.h>

#include "core/footage/open_source.h"
#include "tests/unit/media/clips.h"

namespace vvr {
namespace {

using namespace test;

struct Container {
    std::string name;
    std::string encoding;
};

class Damage : public testing::TestWithParam<Container> {
  protected:
    TempFolder folder;
    std::string clip = walkers_clip(folder, GetParam().name, GetParam().encoding);
};

TEST_P(Damage, ACutClipGivesWhatThereIs) {
    const auto source = footage::open_source(cut(folder, clip, 0.6));
    const auto frames = read_all(*source);
    EXPECT_GT(frames.size(), 15u);
    EXPECT_LT(frames.size(), 75u);
    EXPECT_LE(source->damaged(), 3);
}

TEST_P(Damage, SpoiledBytesAreCountedAndPassed) {
    const auto name = spoiled(folder, clip);
    std::size_t first = 0;
    for (const int threads : {1, 2, 4, 4}) {
        media::SourceOptions options{.threads = threads};
        const auto source = footage::open_source(name, options);
        const auto frames = read_all(*source);
        EXPECT_GT(frames.size(), 25u);
        EXPECT_GT(source->damaged(), 0);
        EXPECT_LE(source->damaged(), 75);
        for (std::size_t i = 1; i < frames.size(); ++i) EXPECT_GE(frames[i].pts, frames[i - 1].pts);
        // The same frames at every run, whatever the number of threads.
        if (first == 0) first = fingerprint(frames);
        EXPECT_EQ(fingerprint(frames), first) << threads << " threads";
        source->rewind();
        EXPECT_EQ(fingerprint(read_all(*source)), first) << threads << " threads, second pass";
    }
}

std::string ending_of(const testing::TestParamInfo<Container>& test) {
    return test.param.name.substr(5);
}

INSTANTIATE_TEST_SUITE_P(Video, Damage,
                         testing::Values(Container{"clip.mp4", "-c:v libx264 -g 25 -bf 2 -movflags faststart"},
                                         Container{"clip.ts", "-c:v libx264 -g 25"}),
                         ending_of);
INSTANTIATE_TEST_SUITE_P(Nightly, Damage,
                         testing::Values(Container{"clip.avi", "-c:v mpeg4"}, Container{"clip.mpg", "-c:v mpeg2video"}),
                         ending_of);

TEST(VideoDamage, AStreamOfNothingButErrorsEnds) {
    const TempFolder folder;
    const auto clip = walkers_clip(folder, "clip.avi", "-c:v mjpeg");
    auto bytes = read_bytes(clip);
    const auto first = bytes.find("00dc");
    for (std::size_t i = first; i < bytes.size(); ++i) {
        if (i % 16 > 7) bytes[i] = static_cast<char>(i * 37);
    }
    write_bytes(folder / "errors.avi", bytes);
    try {
        read_all(*footage::open_source(folder / "errors.avi"));
    } catch (const std::exception&) {
        SUCCEED();
    }
}

}  // namespace
}  // namespace vvr
