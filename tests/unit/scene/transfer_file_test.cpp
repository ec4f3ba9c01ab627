#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

#include "core/scene/transfer_function.h"
#include "tests/support/errors.h"
#include "tests/support/temp_folder.h"

namespace vvr {
namespace {

TEST(TransferFile, HoldsPoints) {
    const scene::TransferFunction transfer = scene::parse_transfer(
        "# my own\n"
        "0 0 0 0 0\n"
        "\n"
        "100, 1, 0.5, 0.25, 0.5  # half\r\n"
        "\t255\t1 1 1 1\n",
        "my.tf");
    ASSERT_EQ(transfer.points().size(), 3U);
    EXPECT_EQ(transfer.points()[1].value, 100);
    EXPECT_EQ(transfer.points()[1].colour, glm::dvec3(1, 0.5, 0.25));
    EXPECT_NEAR(std::exp(-transfer.at(100).w * scene::opacity_unit_distance), 0.5, 1e-12) << "so much goes through";
    EXPECT_EQ(transfer.at(0).w, 0);
    EXPECT_NEAR(std::exp(-transfer.at(255).w * scene::opacity_unit_distance), 0.001, 1e-9)
        << "1 is nearly opaque, not infinite";
}

TEST(TransferFile, SaysWhichLineIsWrong) {
    for (const auto& [text, place, found] :
         {std::tuple{"0 0 0 0 0\n1 2 3\n", "my.tf:2", "3"}, std::tuple{"# a\n0 0 x 0 0\n", "my.tf:2: green", "'x'"},
          std::tuple{"0 0 0 0 1.5", "my.tf:1: opacity", "'1.5'"}, std::tuple{"256 0 0 0 1", "my.tf:1: value", "'256'"},
          std::tuple{"0 nan 0 0 1", "my.tf:1: red", "'nan'"}, std::tuple{"9 0 0 0 0\n9 0 0 0 1\n", "my.tf:2", "9"},
          std::tuple{"# nothing\n", "my.tf", "opacity"}}) {
        test::expect_error(ErrorCode::option_value, [&, lines = text] { scene::parse_transfer(lines, "my.tf"); },
                           {place, found});
    }
}

TEST(TransferFile, IsFoundByNameOrPath) {
    EXPECT_EQ(scene::find_transfer("blue").at(200), scene::default_transfer_function().at(200));
    for (const scene::TransferRow& row : scene::transfer_functions()) {
        EXPECT_GT(scene::find_transfer(row.name).at(255).w, 0) << row.name;
        EXPECT_EQ(scene::find_transfer(row.name).at(0).w, 0) << row.name << ": what is empty is not seen";
    }
    const test::TempFolder folder;
    test::write_bytes(folder / "my.tf", "7 0 0 0 0\n8 1 0 0 1\n");
    EXPECT_EQ(scene::find_transfer(folder / "my.tf").points().size(), 2U);
    test::expect_error(ErrorCode::choice_unknown, [] { scene::find_transfer("heet"); }, {"'heat'", "file"});
    EXPECT_THROW(scene::find_transfer("/"), Error) << "a folder";
}

}  // namespace
}  // namespace vvr
