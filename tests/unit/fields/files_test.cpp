#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include "core/fields/flo_file.h"
#include "core/fields/frame_files.h"
#include "core/fields/seed_list.h"
#include "tests/support/errors.h"
#include "tests/support/planes.h"

namespace vvr {
namespace {

const std::string good_head = "vvr-seeds 1\nframe 3\nsize 40 30\n";

TEST(SeedFile, ReadsWhatItWrote) {
    const fields::SeedList list{
        17, {384, 288}, {{6, 18, 1.25F, -0.1F}, {30.5F, 0, 1e-7F, 3.4e5F, *fields::SeedFlags::parse("0110")}}};
    EXPECT_EQ(fields::parse_seeds(fields::format_seeds(list), ""), list);
    const fields::SeedList none{0, {1, 1}, {}};
    EXPECT_EQ(fields::parse_seeds(fields::format_seeds(none), ""), none);
}

TEST(SeedFile, LooksAsDocumented) {
    EXPECT_EQ(fields::format_seeds({3, {40, 30}, {{6, 18, 1.25F, -0.5F}}}),
              "vvr-seeds 1\nframe 3\nsize 40 30\npoints 1\n# x y u v flag\n6 18 1.25 -0.5 1\n");
}

TEST(SeedFile, TakesCommentsEmptyLinesAndOtherLineEnds) {
    const fields::SeedList list = fields::parse_seeds(
        "# made by hand\r\nvvr-seeds 1\r\n\r\nframe 3\r\nsize 40 30\r\npoints 1\r\n  1\t2  0 0 0\r\n", "");
    ASSERT_EQ(list.seeds.size(), 1U);
    EXPECT_FALSE(list.seeds[0].flags.in(0));
}

TEST(SeedFile, SaysWhatIsWrongAndWhere) {
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"", "s.txt:1"},
        {std::string("\0\xff\x13junk", 7), "s.txt:1"},
        {"vvr-seeds 2\n", "vvr-seeds 1"},
        {"vvr-seeds 1\nsize 40 30\n", "s.txt:2: expected 'frame'"},
        {"vvr-seeds 1\nframe 3\nsize 40\n", "s.txt:3: expected 'size'"},
        {"vvr-seeds 1\nframe x\n", "s.txt:2: 'x'"},
        {"vvr-seeds 1\nframe 3\nsize 0 30\npoints 0\n", "0x30"},
        {good_head + "points -1\n", "'-1'"},
        {good_head + "points 99999999999999999999\n", "'99999999999999999999'"},
        {good_head + "points 2\n1 2 0 0 1\n", "1 of 2"},
        {good_head + "points 1\n1 2 0 0 1\n1 2 0 0 1\n", "s.txt:6"},
        {good_head + "points 1\n1 2 0 0\n", "'1 2 0 0'"},
        {good_head + "points 1\n1 2 0 0 2\n", "'2'"},
        {good_head + "points 1\n1,5 2 0 0 1\n", "'1,5'"},
        {good_head + "points 1\n1 2 nan 0 1\n", "'nan'"},
        {good_head + "points 1\n1 2 0 -inf 1\n", "'-inf'"},
        {good_head + "points 1\n40 2 0 0 1\n", "40, 2"},
        {good_head + "points 1\n-0.5 2 0 0 1\n", "-0.5, 2"}};
    for (const auto& [text, fact] : wrong) {
        test::expect_error(ErrorCode::file_invalid, [&, list = text] { fields::parse_seeds(list, "s.txt"); }, {fact});
    }
}

TEST(SeedFile, AFileThatIsNotThere) {
    test::expect_error(ErrorCode::file_not_found, [] { fields::read_seeds("/nowhere/s.txt"); }, {"'/nowhere/s.txt'"});
    test::expect_error(ErrorCode::not_a_file,
                       [] { fields::read_seeds(std::filesystem::temp_directory_path().string()); });
}

fields::Flow small_flow() {
    fields::Flow flow{Plane<float>({3, 2}, 1.5F), Plane<float>({3, 2}, -2)};
    flow.u.at(2, 1) = 1e10F;
    flow.v.at(0, 1) = 0.25F;
    return flow;
}

TEST(FloFile, HasMiddleburysLayout) {
    const std::string bytes = fields::encode_flo(small_flow());
    ASSERT_EQ(bytes.size(), 12U + 6 * 8);
    EXPECT_EQ(bytes.substr(0, 4), "PIEH");
    EXPECT_EQ(bytes.substr(4, 8), std::string("\3\0\0\0\2\0\0\0", 8));
    float second_row_v = 0;
    std::memcpy(&second_row_v, bytes.data() + 12 + 3 * 8 + 4, 4);
    EXPECT_EQ(second_row_v, 0.25F);
}

TEST(FloFile, ReadsWhatItWrote) {
    const fields::Flow flow = fields::decode_flo(fields::encode_flo(small_flow()), "");
    EXPECT_TRUE(test::same(flow.u, small_flow().u));
    EXPECT_TRUE(test::same(flow.v, small_flow().v));
}

TEST(FloFile, SaysWhatIsWrong) {
    const std::string good = fields::encode_flo(small_flow());
    std::string huge = good;
    huge.replace(4, 4, "\xff\xff\xff\x7f");
    fields::Flow bad = small_flow();
    bad.v.at(1, 0) = std::numeric_limits<float>::quiet_NaN();
    for (const auto& [bytes, fact] :
         std::vector<std::pair<std::string, std::string>>{{"", " 0 bytes"},
                                                          {"PIEJ" + good.substr(4), "PIEH"},
                                                          {good + "x", "61 bytes"},
                                                          {good.substr(0, 59), "59 bytes"},
                                                          {huge, "2147483647x2"},
                                                          {fields::encode_flo(bad), "vector 1"}}) {
        test::expect_error(ErrorCode::file_invalid, [&, file = bytes] { fields::decode_flo(file, "f.flo"); },
                           {"f.flo", fact});
    }
    test::expect_error(ErrorCode::file_not_found, [] { fields::read_flo("/nowhere/f.flo"); }, {"'/nowhere/f.flo'"});
}

TEST(Seeds, FitTheFlowThatTheyHave) {
    fields::Flow flow{Plane<float>({3, 2}), Plane<float>({3, 2}, -2)};
    flow.u.at(2, 1) = 4;
    const std::vector<fields::Seed> seeds{{0, 0, 0, -2}, {2, 1, 4, -2}, {1.5F, 1, 2, -2}};
    EXPECT_EQ(fields::misfit(seeds, flow), nullptr);
    flow.v.at(2, 1) = -2.1F;
    EXPECT_EQ(fields::misfit(seeds, flow), &seeds[1]);
    flow.v.at(2, 1) = std::numeric_limits<float>::infinity();
    EXPECT_EQ(fields::misfit(seeds, flow), &seeds[1]);
    EXPECT_EQ(fields::misfit({}, flow), nullptr);
}

TEST(FrameFiles, HaveTheNumbersOfTheirNames) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("vvr-frame-files-" + std::to_string(::getpid()));
    std::filesystem::create_directory(folder);
    for (const char* const name : {"007.flo", "flow_8.FLO", "9", "x.txt"}) std::ofstream(folder / name).put(' ');
    const fields::FrameFiles files("flow", folder, {".flo"});
    EXPECT_EQ(files.of(7), folder / "007.flo");
    EXPECT_EQ(files.of(8), folder / "flow_8.FLO");
    EXPECT_EQ(files.find(9), nullptr);
    EXPECT_EQ(files.last(), 8);
    files.check_end(9);
    test::expect_error(ErrorCode::file_not_found, [&] { files.of(9); }, {"flow", "frame 9", "'007.flo'"});
    test::expect_error(ErrorCode::file_invalid, [&] { files.check_end(8); }, {"flow_8.FLO", "frame 7"});
    std::ofstream(folder / "99999999999999999999.flo").put(' ');
    test::expect_error(ErrorCode::input_unsuitable, [&] { fields::files_by_frame(folder, {".flo"}); });
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace vvr
