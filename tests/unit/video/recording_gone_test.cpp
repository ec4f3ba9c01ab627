#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/video/recorder_names.h"
#include "tests/support/errors.h"
#include "tests/unit/video/clips.h"

namespace vvr {
namespace {

using namespace test;
namespace fs = std::filesystem;

/// Frames from here to the end.
int count(video::FrameSource& source) {
    int frames = 0;
    while (source.next()) ++frames;
    return frames;
}

// A disk that is unmounted, or a recorder that makes room, between the first look and the pass that counts.
TEST(RecordingSource, SaysThatItsFilesHaveGone) {
    const TempFolder folder;
    const std::string day = folder / "day";
    fs::create_directory(day);
    counting_clip(folder, "clip.avi", "-c:v mpeg4");
    for (const char* name : {"2026-11-21_10-00-00.avi", "2026-11-21_10-00-04.avi"}) {
        fs::copy_file(folder / "clip.avi", fs::path(day) / name);
    }
    std::vector<std::string> warnings;
    const auto source = video::open_sources({day}, {}, video::RecorderNames(), warnings);
    EXPECT_EQ(count(*source), 200);

    fs::rename(day, folder / "away");
    source->rewind();
    test::expect_error(ErrorCode::io, [&] { source->next(); }, {"2 files"});

    fs::rename(folder / "away", day);
    fs::remove(fs::path(day) / "2026-11-21_10-00-04.avi");
    source->rewind();
    EXPECT_EQ(count(*source), 100) << "what is left is read";
    EXPECT_EQ(source->problems().size(), 1U) << "and the rest is named";
}

}  // namespace
}  // namespace vvr
