#include <string>

#include <gtest/gtest.h>

#include "core/image/picture_file.h"
#include "tests/support/errors.h"

namespace vvr {
namespace {

TEST(Encoders, SayWhatIsTooLargeOrEmpty) {
    const auto encode = [](const char* name, Size size) {
        return [=] { image::encode_picture(name, image::Picture{Plane<image::Rgba>(size)}); };
    };
    test::expect_error(ErrorCode::io, encode("a.jpg", {70000, 1}), {"'a.jpg'", "70000x1", "65500"});
    test::expect_error(ErrorCode::io, encode("a.png", {0, 5}), {"'a.png'"});
}

TEST(Encoders, CutADescriptionThatIsTooLong) {
    const auto bytes = image::encode_picture("a.jpg", image::Picture{Plane<image::Rgba>({8, 8})},
                                             {{"title", std::string(70000, 'x')}});
    EXPECT_EQ(image::settings_of(image::decode_samples("a.jpg", bytes)).front().second.substr(0, 3), "xxx");
}

TEST(Encoders, MarkTextsOfAPngAsUtf8) {
    const image::Metadata settings{{"title", "Süd, 10 °C"}, {"theme", "light"}};
    const auto png = image::encode_picture("a.png", image::Picture{Plane<image::Rgba>({8, 8})}, settings);
    const std::string file(reinterpret_cast<const char*>(png.data()), png.size());
    EXPECT_NE(file.find("iTXtvvr:title"), std::string::npos);
    EXPECT_NE(file.find("tEXtvvr:theme"), std::string::npos);
    EXPECT_EQ(image::settings_of(image::decode_samples("a.png", png)), settings);
}

TEST(Encoders, GiveAFrameItsColours) {
    const auto png = image::encode_picture("a.png", Plane<Bgr>({3, 2}, Bgr{10, 20, 30}));
    const image::Samples samples = image::decode_samples("a.png", png);
    EXPECT_EQ(samples.channels, (std::vector<std::string>{"R", "G", "B"}));
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(255 * samples.at(2, 1)[c], 30 - 10 * static_cast<int>(c), 1e-3);
}

}  // namespace
}  // namespace vvr
