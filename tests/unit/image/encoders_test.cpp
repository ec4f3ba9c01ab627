#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/image/jpeg_encoder.h"
#include "core/image/png_encoder.h"
#include "tests/support/errors.h"

namespace vvr {
namespace {

template <class Encode>
std::string error_of(const Encode& encode) {
    return test::error_text(ErrorKind::io, encode);
}

TEST(Encoders, SayWhatTheirLibrariesRefuse) {
    const std::vector<std::uint8_t> values(3 * 70000);
    EXPECT_EQ(error_of([&] {
                  encode_jpeg({.size = {70000, 1}, .values = values});
              }),
              "cannot encode a JPEG file of 70000x1: Maximum supported image dimension is 65500 pixels");
    EXPECT_EQ(error_of([&] {
                  encode_png({.size = {0, 5}, .values = values});
              }),
              "cannot encode a PNG file of 0x5: Invalid IHDR data");
}

TEST(Encoders, CutACommentThatIsTooLong) {
    const std::vector<std::uint8_t> values(3 * 8 * 8);
    const auto bytes = encode_jpeg({.size = {8, 8}, .values = values, .comment = std::string(70000, 'x')});
    EXPECT_GT(bytes.size(), 65533U);
    EXPECT_LT(bytes.size(), 70000U);
}

}  // namespace
}  // namespace vvr
