#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/archive/clips.h"
#include "core/archive/output_files.h"
#include "core/base/digest.h"
#include "core/base/file.h"
#include "core/footage/input_files.h"
#include "core/footage/recorder_names.h"

namespace vvr {
namespace {

TEST(ArchiveNames, AreTextAndBackWhateverTheirBytes) {
    EXPECT_EQ(archive::text_of_path("cam1/Büro 2.avi"), "cam1/Büro 2.avi");
    EXPECT_EQ(archive::text_of_path("a\xFF\n%.avi"), "a%FF%0A%25.avi");
    // Longer than needed, half of a pair, beyond Unicode, cut off.
    for (const std::string bad : {"\xC0\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82", "\xF0\x9F\x98"}) {
        EXPECT_EQ(archive::text_of_path(bad).find_first_not_of("%0123456789ABCDEF"), std::string::npos) << bad;
    }
    std::string all;
    for (int byte = 1; byte < 256; ++byte) all += static_cast<char>(byte);
    for (const std::string& path : {all, std::string("%41"), std::string("€😀\xE2")}) {
        EXPECT_EQ(archive::path_of_text(archive::text_of_path(path)), path);
        EXPECT_NO_THROW(nlohmann::json(archive::text_of_path(path)).dump());
    }
}

TEST(ArchiveNames, ArePlainOrNotTaken) {
    for (const std::string& name : {std::string("a"), std::string("..."), std::string(".a"), std::string("a\n\xFF"),
                                    std::string(longest_name, 'n')}) {
        EXPECT_TRUE(is_plain_name(name)) << name;
        EXPECT_TRUE(is_plain_path("cam/" + name)) << name;
    }
    for (const std::string& name : {std::string(), std::string("."), std::string(".."), std::string("a\0", 2),
                                    std::string(longest_name + 1, 'n')}) {
        EXPECT_FALSE(is_plain_name(name)) << name;
        for (const std::string& path : {name, name + "/x", "x/" + name, "x/" + name + "/x"}) {
            EXPECT_FALSE(is_plain_path(path)) << path;
        }
    }
    for (const char* path : {"/x", "../x", "x/../../y", "x/", "/"}) {
        EXPECT_FALSE(is_plain_name(path)) << path;
        EXPECT_FALSE(is_plain_path(path)) << path;
    }
}

TEST(ArchiveNames, KnowTheCameraByItsFolders) {
    const auto camera_of = [](const std::string& path) { return footage::RecorderNames().camera_of(path); };
    EXPECT_EQ(camera_of("x.avi"), "");
    EXPECT_EQ(camera_of("cam1/x.avi"), "cam1");
    EXPECT_EQ(camera_of("house/gate/x.avi"), "house/gate");
    for (const char* date : {"2026", "2026-11", "20261121", "2026_11_21", "2026/11/21", "1999.12.31/morning"}) {
        EXPECT_EQ(camera_of("house/gate/" + std::string(date) + "/x.avi"), "house/gate") << date;
    }
    for (const char* name : {"101", "20", "2026x", "20261", "2026 old"}) {
        EXPECT_EQ(camera_of(std::string(name) + "/x.avi"), name);
    }
    EXPECT_EQ(camera_of("2026-11-21/x.avi"), "");
}

TEST(ArchiveNames, TellClips) {
    EXPECT_TRUE(std::ranges::is_sorted(footage::video_extensions()));
    const archive::ClipNames videos;
    for (const char* name : {"a.avi", "cam/b.MP4", "c.d.mkv", "e.ts"}) EXPECT_TRUE(videos.matches(name)) << name;
    for (const char* name : {"a.avi.png", "avi", ".avi", "cam.avi/b", "c.txt", "d.jpg", "e"}) {
        EXPECT_FALSE(videos.matches(name)) << name;
    }
    const archive::ClipNames some({"*.dat", "cam?/*.avi"});
    EXPECT_TRUE(some.matches("deep/down/x.dat"));
    EXPECT_TRUE(some.matches("cam1/x.avi"));
    EXPECT_FALSE(some.matches("cam1/deep/x.avi"));
    EXPECT_FALSE(some.matches("x.avi"));
}

TEST(ArchiveShards, ShareOutEveryClipOnce) {
    // As published by those who made it.
    EXPECT_EQ(fnv1a(""), 0xcbf29ce484222325);
    EXPECT_EQ(fnv1a("a"), 0xaf63dc4c8601ec8c);
    EXPECT_EQ(fnv1a("foobar"), 0x85944171f73967e8);
    std::vector<int> clips(7);
    for (int k = 0; k < 7000; ++k) {
        int holders = 0;
        for (std::uint64_t shard = 0; shard < 7; ++shard) {
            if (!archive::Shard{shard, 7}.contains("cam/" + std::to_string(k) + ".avi")) continue;
            ++holders;
            ++clips[shard];
        }
        EXPECT_EQ(holders, 1);
    }
    for (const int count : clips) EXPECT_NEAR(count, 1000, 120);
}

}  // namespace
}  // namespace vvr
