#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/console.h"
#include "cli/workers/archive_progress.h"

namespace vvr {
namespace {

TEST(ArchiveProgress, CountsClipsByTheirSize) {
    const workers::ArchiveProgress progress{12, 3, 1000, 300};
    const std::vector<workers::ClipProgress> running{{"gate/08.mp4", 200, 0.5}, {"hall/08.mp4", 100, 1}};
    EXPECT_EQ(workers::progress_text(progress, running, 5, 200),
              "archive [==========          ] 50 %, 5 s left; 3 of 12 clips; gate/08.mp4 50 %, hall/08.mp4 is drawn");
    EXPECT_EQ(workers::progress_text({1, 0, 0, 0}, {}, 5, 200), "archive [                    ] 0 %; 0 of 1 clip");
}

TEST(ArchiveProgress, FitsIntoALineWhateverTheNamesAre) {
    const workers::ArchiveProgress progress{1, 0, 10, 0};
    const std::vector<workers::ClipProgress> running{
        {"a\n\x1b[2J\xE2\x80\xAE\xFF \xE5\xBA\xAD\xE5\xBA\xAD.mp4", 10, 0.1}};
    const std::string whole = workers::progress_text(progress, running, 0, 500);
    for (const char c : {'\n', '\x1b', '\xFF'}) EXPECT_EQ(whole.find(c), std::string::npos) << whole;
    EXPECT_EQ(whole.find("\xE2\x80\xAE"), std::string::npos) << whole;
    for (std::size_t columns = 0; columns < whole.size(); ++columns) {
        const std::string line = workers::progress_text(progress, running, 0, columns);
        EXPECT_LE(line.size(), columns * 3 / 2 + 1) << line;
        EXPECT_TRUE(whole.starts_with(line)) << line;
    }
}

TEST(Progress, TellsPercentAndTheTimeThatIsLeft) {
    EXPECT_EQ(cli::progress_text("frames", 50, 200, 4), "frames [=====               ] 25 %, 12 s left");
    EXPECT_EQ(cli::progress_text("frames", 50, 200, 1), "frames [=====               ] 25 %") << "too early";
    EXPECT_EQ(cli::progress_text("frames", 250, 200, 9), "frames [====================] 100 %") << "a wrong header";
    EXPECT_EQ(cli::progress_text("frames", 50, 0, 4), "frames 50") << "an unknown length";
}

}  // namespace
}  // namespace vvr
