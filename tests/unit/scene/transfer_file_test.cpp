#include <cmath>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/scene/transfer_function.h"
#include "tests/support/errors.h"

namespace vvr {
namespace {

std::string error_of(const std::string& text) {
    return test::error_text(ErrorKind::usage, [&] { scene::parse_transfer(text, "my.tf"); });
}

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
    EXPECT_EQ(error_of("0 0 0 0 0\n1 2 3\n"), "my.tf:2: found 3 numbers; give 5: value red green blue opacity");
    EXPECT_EQ(error_of("# a\n0 0 x 0 0\n"), "my.tf:2: green is 'x'; give a number from 0 to 1");
    EXPECT_EQ(error_of("0 0 0 0 1.5"), "my.tf:1: opacity is '1.5'; give a number from 0 to 1");
    EXPECT_EQ(error_of("256 0 0 0 1"), "my.tf:1: value is '256'; give a number from 0 to 255");
    EXPECT_EQ(error_of("0 nan 0 0 1"), "my.tf:1: red is 'nan'; give a number from 0 to 1");
    EXPECT_EQ(error_of("9 0 0 0 0\n9 0 0 0 1\n"), "my.tf:2: value 9 follows 9; values must increase");
    EXPECT_EQ(error_of("# nothing\n"),
              "my.tf: found no points; give at least one line with: value red green blue opacity");
}

TEST(TransferFile, IsFoundByNameOrPath) {
    EXPECT_EQ(scene::find_transfer("blue").at(200), scene::default_transfer_function().at(200));
    for (const scene::TransferRow& row : scene::transfer_functions()) {
        EXPECT_GT(scene::find_transfer(row.name).at(255).w, 0) << row.name;
        EXPECT_EQ(scene::find_transfer(row.name).at(0).w, 0) << row.name << ": what is empty is not seen";
    }
    const auto path = std::filesystem::temp_directory_path() / ("vvr-" + std::to_string(::getpid()) + ".tf");
    std::ofstream(path) << "7 0 0 0 0\n8 1 0 0 1\n";
    EXPECT_EQ(scene::find_transfer(path.string()).points().size(), 2U);
    std::filesystem::remove(path);
    try {
        scene::find_transfer("heet");
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "transfer: 'heet' is unknown (did you mean 'heat'?); choose one of: blue, grey, heat, "
                     "viridis, magma, coolwarm, mist, solid, bands, signed, or the name of a file");
    }
    EXPECT_THROW(scene::find_transfer("/"), Error) << "a folder";
}

}  // namespace
}  // namespace vvr
