#include "core/media/container.h"

#include <string_view>
#include <tuple>

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace vvr {
namespace {

TEST(Container, IsThatOfTheFilesEnding) {
    const std::tuple<const char*, std::string_view> files[] = {
        {"piece.mp4", "mp4"},      {"Piece.MP4", "mp4"}, {"a/piece.mov", "mov"}, {"piece.m4v", "mp4"},
        {"piece.mkv", "matroska"}, {"piece.avi", "avi"}, {"piece.webm", "webm"}};
    for (const auto& [file, muxer] : files) EXPECT_EQ(media::container_of(file).muxer, muxer) << file;
    EXPECT_THROW(media::container_of("piece.xyz"), Error);
    EXPECT_THROW(media::container_of("piece"), Error);
}

}  // namespace
}  // namespace vvr
