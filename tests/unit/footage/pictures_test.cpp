#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/footage/open_source.h"
#include "tests/unit/media/clips.h"

namespace vvr {
namespace {

using namespace test;

class Pictures : public testing::Test {
  protected:
    /// Pictures of the counting clip, from 0.
    void write(const std::string& pattern, int count) {
        counting_clip(folder, pattern, "-frames:v " + std::to_string(count) + " -start_number 0");
        std::filesystem::remove(folder / (pattern + ".y4m"));
    }

    void expect_counts(const std::string& name, std::size_t count) {
        const auto source = footage::open_source(name);
        const auto frames = read_all(*source);
        ASSERT_EQ(frames.size(), count) << name;
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_NEAR(middle_of(frames[i]), level(static_cast<std::int64_t>(i)), 2) << name << " " << i;
            EXPECT_EQ(frames[i].index, static_cast<std::int64_t>(i));
            EXPECT_DOUBLE_EQ(frames[i].pts, static_cast<double>(i) / 25);
        }
    }

    TempFolder folder;
};

TEST_F(Pictures, ComeInNaturalOrder) {
    write("frame%d.png", 12);
    expect_counts(folder.path(), 12);
    expect_counts(folder / "frame%d.png", 12);
    expect_counts(folder / "*.png", 12);
    expect_counts(folder / "frame[0-9]*.png", 12);
    expect_counts(folder / "frame?.png", 10);
}

TEST_F(Pictures, PatternsOfFixedWidth) {
    write("f%05d.png", 12);
    expect_counts(folder / "f%05d.png", 12);
    EXPECT_THROW(footage::open_source(folder / "f%03d.png"), Error);
}

TEST_F(Pictures, OtherFilesAreLeftOut) {
    write("f%02d.jpg", 3);
    write_bytes(folder / "notes.txt", "no picture");
    write_bytes(folder / ".hidden.png", "no picture");
    expect_counts(folder.path(), 3);
}

TEST_F(Pictures, ThoseThatDoNotDecodeAreCounted) {
    write("f%02d.png", 6);
    write_bytes(folder / "f02.png", "no picture");
    write_bytes(folder / "f04.png", "");
    const auto source = footage::open_source(folder.path());
    const auto frames = read_all(*source);
    ASSERT_EQ(frames.size(), 4u);
    EXPECT_EQ(source->damaged(), 2);
    EXPECT_EQ(frames[2].index, 3);
    EXPECT_NEAR(middle_of(frames[2]), level(3), 1);
    source->rewind();
    EXPECT_EQ(source->damaged(), 0);
    EXPECT_EQ(read_all(*source).size(), 4u);
}

TEST_F(Pictures, MayChangeTheirSizeAndFormat) {
    write("f%02d.png", 4);
    ffmpeg("-f lavfi -i color=gray:s=123x45 -frames:v 1 -update 1 " + quoted(folder / "f02.png"));
    ffmpeg("-f lavfi -i color=gray:s=64x48 -frames:v 1 -update 1 " + quoted(folder / "f05.jpg"));
    const auto frames = read_all(*footage::open_source(folder.path()));
    ASSERT_EQ(frames.size(), 5u);
    for (const auto& frame : frames) EXPECT_EQ(frame.grey.size(), (Size{64, 48}));
}

TEST_F(Pictures, HaveTheRateThatIsAskedFor) {
    write("f%02d.png", 10);
    media::SourceOptions options{.rate = 2};
    const auto source = footage::open_source(folder.path(), options);
    EXPECT_DOUBLE_EQ(source->info().duration, 5);
    EXPECT_EQ(source->info().frames, 10);
    EXPECT_EQ(source->info().container, "pictures");
    EXPECT_EQ(source->info().codec, "png");
    source->seek(1);
    const auto frames = read_all(*source);
    ASSERT_EQ(frames.size(), 8u);
    EXPECT_EQ(frames.front().index, 2);
    EXPECT_DOUBLE_EQ(frames.front().pts, 1);
    EXPECT_DOUBLE_EQ(frames.back().pts, 4.5);
    EXPECT_EQ(source->sample(3).size(), 3u);
    EXPECT_EQ(read_all(*source).size(), 10u);
}

TEST_F(Pictures, OnePictureIsAVideoOfOneFrame) {
    write("f%d.png", 1);
    const auto frames = read_all(*footage::open_source(folder / "f0.png"));
    ASSERT_EQ(frames.size(), 1u);
    EXPECT_NEAR(middle_of(frames[0]), level(0), 1);
}

}  // namespace
}  // namespace vvr
