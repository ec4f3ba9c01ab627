#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "core/fields/flo_file.h"
#include "core/fields/seed_list.h"
#include "tests/support/errors.h"

namespace vvr {
namespace {

template <class Call>
std::string error_of(const Call& call) {
    return test::error_text(ErrorKind::io, call);
}

std::string seeds_error(const std::string& text) {
    return error_of([&] { fields::parse_seeds(text, "s.txt"); });
}

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
    EXPECT_NE(seeds_error("").find("s.txt:1: expected the first line 'vvr-seeds 1'"), std::string::npos);
    EXPECT_NE(seeds_error(std::string("\0\xff\x13junk", 7)).find("s.txt:1: expected the first line"),
              std::string::npos);
    EXPECT_NE(seeds_error("vvr-seeds 2\n").find("expected the first line"), std::string::npos);
    EXPECT_NE(seeds_error("vvr-seeds 1\nsize 40 30\n").find("s.txt:2: expected 'frame' and 1 number"),
              std::string::npos);
    EXPECT_NE(seeds_error("vvr-seeds 1\nframe 3\nsize 40\n").find("s.txt:3: expected 'size' and 2 numbers"),
              std::string::npos);
    EXPECT_NE(seeds_error("vvr-seeds 1\nframe x\n").find("s.txt:2: 'x' is not a number"), std::string::npos);
    EXPECT_NE(seeds_error("vvr-seeds 1\nframe 3\nsize 0 30\npoints 0\n")
                  .find("a field has sides of 1 to 65536 pixels, found 0x30"),
              std::string::npos);
    EXPECT_NE(seeds_error(good_head + "points -1\n").find("'-1' is not a number"), std::string::npos);
    EXPECT_NE(seeds_error(good_head + "points 99999999999999999999\n").find("is not a number"), std::string::npos);
    EXPECT_NE(seeds_error(good_head + "points 2\n1 2 0 0 1\n").find("s.txt:6: the file ends after 1 of 2 points"),
              std::string::npos);
    EXPECT_NE(seeds_error(good_head + "points 1\n1 2 0 0 1\n1 2 0 0 1\n")
                  .find("s.txt:6: there are more points than 'points 1' says"),
              std::string::npos);
    EXPECT_NE(seeds_error(good_head + "points 1\n1 2 0 0\n").find("expected a point 'x y u v flag', found '1 2 0 0'"),
              std::string::npos);
    EXPECT_NE(seeds_error(good_head + "points 1\n1 2 0 0 2\n")
                  .find("expected a flag of 1 to 32 digits, each 0 or 1, found '2'"),
              std::string::npos);
    EXPECT_NE(seeds_error(good_head + "points 1\n1,5 2 0 0 1\n").find("'1,5' is not a number"), std::string::npos);
    EXPECT_NE(seeds_error(good_head + "points 1\n1 2 nan 0 1\n").find("'nan' is not a finite number"),
              std::string::npos);
    EXPECT_NE(seeds_error(good_head + "points 1\n1 2 0 -inf 1\n").find("'-inf' is not a finite number"),
              std::string::npos);
    EXPECT_NE(seeds_error(good_head + "points 1\n40 2 0 0 1\n").find("the point 40, 2 lies outside the field of 40x30"),
              std::string::npos);
    EXPECT_NE(seeds_error(good_head + "points 1\n-0.5 2 0 0 1\n").find("outside"), std::string::npos);
}

TEST(SeedFile, AFileThatIsNotThere) {
    EXPECT_EQ(error_of([] { fields::read_seeds("/nowhere/s.txt"); }),
              "cannot open '/nowhere/s.txt': No such file or directory; check its name and permissions");
    const std::string folder = std::filesystem::temp_directory_path().string();
    EXPECT_EQ(error_of([&] { fields::read_seeds(folder); }),
              "cannot open '" + folder + "': Is a directory; check its name and permissions");
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
    EXPECT_EQ(flow.u.size(), (Size{3, 2}));
    EXPECT_TRUE(std::ranges::equal(flow.u.pixels(), small_flow().u.pixels()));
    EXPECT_TRUE(std::ranges::equal(flow.v.pixels(), small_flow().v.pixels()));
}

TEST(FloFile, SaysWhatIsWrong) {
    const auto flo_error = [](const std::string& bytes) {
        return error_of([&] { fields::decode_flo(bytes, "f.flo"); });
    };
    const std::string good = fields::encode_flo(small_flow());
    EXPECT_EQ(
        flo_error(""),
        "f.flo: not a flow file: it has 0 bytes, fewer than the 12 of a header; docs/formats.md describes the format");
    EXPECT_EQ(flo_error("PIEJ" + good.substr(4)),
              "f.flo: not a flow file: it doesn't begin with the number 202021.25 (\"PIEH\"); docs/formats.md "
              "describes the format");
    EXPECT_EQ(
        flo_error(good + "x"),
        "f.flo: not a flow file: it has 61 bytes, but a flow of 3x2 needs 60; docs/formats.md describes the format");
    EXPECT_EQ(
        flo_error(good.substr(0, 59)),
        "f.flo: not a flow file: it has 59 bytes, but a flow of 3x2 needs 60; docs/formats.md describes the format");
    std::string huge = good;
    huge.replace(4, 4, "\xff\xff\xff\x7f");
    EXPECT_EQ(flo_error(huge),
              "f.flo: not a flow file: its header gives 2147483647x2 pixels, but a side has 1 to 65536; "
              "docs/formats.md describes the format");
    fields::Flow bad = small_flow();
    bad.v.at(1, 0) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(flo_error(fields::encode_flo(bad)),
              "f.flo: not a flow file: vector 1 is not a number; docs/formats.md describes the format");
    EXPECT_EQ(error_of([] { fields::read_flo("/nowhere/f.flo"); }),
              "cannot open '/nowhere/f.flo': No such file or directory; check its name and permissions");
}

}  // namespace
}  // namespace vvr
