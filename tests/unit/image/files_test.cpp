#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/atomic_file.h"
#include "core/base/digest.h"
#include "core/base/error.h"
#include "core/image/picture.h"
#include "core/image/picture_file.h"
#include "core/image/video_encoder.h"
#include "tests/support/errors.h"
#include "tests/support/planes.h"
#include "tests/support/temp_folder.h"

namespace vvr {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

using test::read_bytes;

class ImageTest : public testing::Test {
  protected:
    test::TempFolder folder;
};

class ImageFormatTest : public ImageTest, public testing::WithParamInterface<std::string> {};

image::Picture gradient(Size size, float alpha = 1) {
    return {test::plane_of<image::Rgba>(size, [&](int i, int j) {
        const float x = static_cast<float>(i) / static_cast<float>(size.width);
        const float y = static_cast<float>(j) / static_cast<float>(size.height);
        return image::Rgba{x * alpha, y * alpha, 0.25F * alpha, alpha};
    })};
}

/// A file as the picture that was written.
image::Picture read_picture(const fs::path& path) {
    const image::Samples samples = image::read_samples(path);
    const std::size_t channels = samples.channels.size();
    const auto named = [&](std::string_view name) { return std::ranges::find(samples.channels, name); };
    const auto index_of = [&](auto at) { return static_cast<std::size_t>(at - samples.channels.begin()); };
    const auto alpha = named("A");
    image::Picture picture{Plane<image::Rgba>(samples.size)};
    for (const image::PixelDataChannel& channel : image::pixel_data_channels) {
        if (named(channel.name) != samples.channels.end()) {
            picture.pixel_data.*channel.plane = Plane<float>(samples.size);
        }
    }
    for (std::size_t i = 0; i < picture.pixels.pixels().size(); ++i) {
        const auto from = std::span(samples.values).subspan(i * channels, channels);
        picture.pixels.pixels()[i] = {from[0], from[1], from[2],
                                      alpha == samples.channels.end() ? 1 : from[index_of(alpha)]};
        for (const image::PixelDataChannel& channel : image::pixel_data_channels) {
            Plane<float>& plane = picture.pixel_data.*channel.plane;
            if (!plane.empty()) plane.pixels()[i] = from[index_of(named(channel.name))];
        }
    }
    return picture;
}

/// The largest difference of any value.
float apart(const image::Picture& a, const image::Picture& b) {
    if (a.pixels.size() != b.pixels.size()) return std::numeric_limits<float>::infinity();
    float most = 0;
    for (std::size_t i = 0; i < a.pixels.pixels().size(); ++i) {
        for (int c = 0; c < 4; ++c) {
            most = std::max(most, std::abs(a.pixels.pixels()[i][c] - b.pixels.pixels()[i][c]));
        }
    }
    return most;
}

TEST_P(ImageFormatTest, ComesBackWithItsSettings) {
    const image::Picture picture = gradient({64, 48});
    const image::Metadata metadata{{"size", "64x48"}, {"camera", "-20,25"}, {"show", "volume,arrows"}};
    image::write_picture(folder / ("a" + GetParam()), picture, metadata);

    EXPECT_LT(apart(picture, read_picture(folder / ("a" + GetParam()))),
              GetParam().starts_with(".jp") ? 0.05 : 0.5001 / 255);
    image::Metadata read = image::settings_of(image::read_samples(folder / ("a" + GetParam())));
    std::ranges::sort(read);
    EXPECT_EQ(read, (image::Metadata{{"camera", "-20,25"}, {"show", "volume,arrows"}, {"size", "64x48"}}));
    EXPECT_EQ(folder.files(), 1);
}

TEST_P(ImageFormatTest, SameBytesAtAnotherTime) {
    image::write_picture(folder / ("a" + GetParam()), gradient({32, 16}), {{"step", "1"}});
    ::sleep(1);  // dates in pictures count seconds
    image::write_picture(folder / ("b" + GetParam()), gradient({32, 16}), {{"step", "1"}});
    EXPECT_EQ(read_bytes(folder / ("a" + GetParam())), read_bytes(folder / ("b" + GetParam())));
}

TEST_P(ImageFormatTest, FullDiskLeavesNothing) {
    const auto old_action = std::signal(SIGXFSZ, SIG_IGN);
    rlimit old_limit{};
    getrlimit(RLIMIT_FSIZE, &old_limit);
    const rlimit limit{100, old_limit.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
    test::expect_error(ErrorCode::disk_full, [&] {
        image::write_picture(folder / ("a" + GetParam()), gradient({64, 48}));
    });
    setrlimit(RLIMIT_FSIZE, &old_limit);
    std::signal(SIGXFSZ, old_action);
    EXPECT_EQ(folder.files(), 0);
}

INSTANTIATE_TEST_SUITE_P(Formats, ImageFormatTest, testing::ValuesIn(image::picture_file_extensions()),
                         [](const auto& format) { return format.param.substr(1); });

TEST_F(ImageTest, AlphaIsKeptWhereTheFormatHasIt) {
    const image::Picture picture = gradient({16, 16}, 0.5F);
    for (const std::string name : {"a.png", "a.tif", "a.exr"}) {
        image::write_picture(folder / name, picture);
        EXPECT_LT(apart(picture, read_picture(folder / name)), 1.01 / 255) << name;
    }
}

TEST_F(ImageTest, PixelDataComesBackExactlyFromTheFormatThatHoldsIt) {
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    for (const float alpha : {1.0F, 0.5F}) {
        image::Picture picture = gradient({5, 3}, alpha);
        picture.pixel_data = {Plane<float>({5, 3}, none), Plane<float>({5, 3}, none), Plane<float>({5, 3}, -1)};
        picture.pixel_data.depth.at(4, 1) = 2.7182818F;
        picture.pixel_data.time.at(4, 1) = 86399.96F;
        picture.pixel_data.frame.at(4, 1) = 2159999;  // more than a half float holds
        image::write_picture(folder / "a.exr", picture);
        const image::Picture read = read_picture(folder / "a.exr");
        EXPECT_LT(apart(picture, read), 1.0 / 255) << "colours and alpha as ever";
        for (const auto plane : {&image::PixelData::depth, &image::PixelData::time, &image::PixelData::frame}) {
            ASSERT_EQ((read.pixel_data.*plane).size(), picture.pixels.size());
            EXPECT_EQ((read.pixel_data.*plane).at(4, 1), (picture.pixel_data.*plane).at(4, 1));
        }
        EXPECT_TRUE(std::isnan(read.pixel_data.time.at(0, 0)) && std::isnan(read.pixel_data.depth.at(0, 0)));
        EXPECT_EQ(read.pixel_data.frame.at(0, 0), -1);

        EXPECT_TRUE(read.pixel_data.object.empty()) << "a plane that is not there is no channel";

        picture.pixel_data.object = Plane<float>({5, 3});
        picture.pixel_data.object.at(2, 1) = 65'535;
        image::write_picture(folder / "b.exr", picture);
        const image::Picture with_objects = read_picture(folder / "b.exr");
        ASSERT_EQ(with_objects.pixel_data.object.size(), picture.pixels.size());
        EXPECT_EQ(with_objects.pixel_data.object.at(2, 1), 65'535);
        EXPECT_EQ(with_objects.pixel_data.object.at(0, 0), 0);
        EXPECT_EQ(with_objects.pixel_data.frame.at(4, 1), 2159999);

        image::write_picture(folder / "a.png", picture);
        EXPECT_TRUE(read_picture(folder / "a.png").pixel_data.empty());
    }
    EXPECT_TRUE(image::holds_pixel_data("out.EXR"));
    EXPECT_FALSE(image::holds_pixel_data("out.tif"));
}

TEST_F(ImageTest, ReplacesAsAWholeAndFollowsLinks) {
    image::write_picture(folder / "a.png", gradient({8, 8}));
    fs::create_symlink(folder / "a.png", folder / "link.png");
    image::write_picture(folder / "link.png", gradient({16, 8}));
    EXPECT_TRUE(fs::is_symlink(folder / "link.png"));
    EXPECT_EQ(read_picture(folder / "a.png").pixels.size(), (Size{16, 8}));
    EXPECT_EQ(folder.files(), 2);
    // To a file that is not there yet, in another folder, through another link.
    fs::create_directory(folder / "other");
    fs::create_symlink("other/link.png", folder / "dangling.png");
    fs::create_symlink("real.png", folder / "other/link.png");
    image::check_picture_path(folder / "dangling.png");
    image::write_picture(folder / "dangling.png", gradient({4, 8}));
    EXPECT_TRUE(fs::is_symlink(folder / "dangling.png"));
    EXPECT_TRUE(fs::is_symlink(folder / "other/link.png"));
    EXPECT_EQ(read_picture(folder / "other/real.png").pixels.size(), (Size{4, 8}));
    fs::create_symlink("circle.png", folder / "circle.png");
    test::expect_error(ErrorCode::io, [&] { image::check_picture_path(folder / "circle.png"); }, {"circle.png"});
}

TEST_F(ImageTest, EndingsInCapitalsCount) {
    EXPECT_NO_THROW(image::check_picture_path(folder / "A.PNG"));
}

TEST_F(ImageTest, ReadingWhatIsNoPictureSaysSo) {
    test::write_bytes(folder / "text.png", "not a picture");
    test::expect_error(ErrorCode::file_invalid, [&] { read_picture(folder / "text.png"); });
    test::expect_error(ErrorCode::file_not_found, [&] { read_picture(folder / "none.png"); }, {"none.png"});
}

TEST_F(ImageTest, RemovesWhatAKilledProgramLeft) {
    const auto part = [&](int number) { return folder / fmt::format(".vvr-{:016x}-{}.part", fnv1a("x"), number); };
    const auto leave = [&](int number) {
        test::write_bytes(part(number), "half");
        fs::last_write_time(part(number), fs::file_time_type::clock::now() - 61min);
    };
    const auto replace = [&](const std::string& text) {
        replace_file(folder / "x", std::as_bytes(std::span(text)));
        EXPECT_EQ(read_bytes(folder / "x"), text);
    };
    leave(0);
    leave(1);
    replace("first");
    EXPECT_EQ(folder.files(), 1) << "two that were left";
    leave(0);
    const int writer = ::open(part(0).c_str(), O_WRONLY);
    ASSERT_EQ(::flock(writer, LOCK_EX), 0);
    replace("second");
    const std::vector<std::string> names{"x"};
    remove_leftovers(folder.path(), names);
    EXPECT_EQ(read_bytes(part(0)), "half") << "somebody is writing it";
    ::close(writer);
    check_file_path(folder / "x");
    EXPECT_EQ(folder.files(), 1);
    test::write_bytes(part(0), "half");
    remove_leftovers(folder.path(), names);
    EXPECT_EQ(folder.files(), 1) << "young, but known to be nobody's";
}

TEST_F(ImageTest, WritesThroughNoLinkThatLeadsRound) {
    fs::create_symlink("round", folder / "round");
    const std::string text = "text";
    test::expect_error(ErrorCode::io, [&] { replace_file(folder / "round", std::as_bytes(std::span(text))); });
    EXPECT_EQ(folder.files(), 1);
}

TEST_F(ImageTest, WritesAFileInPiecesAtAnyPlace) {
    const auto put = [](const WriteAt& write_at, std::int64_t offset, std::string_view text) {
        write_at(offset, std::as_bytes(std::span(text)));
    };
    replace_file(folder / "x", [&](const WriteAt& write_at) {
        put(write_at, 4, "tail");
        put(write_at, 0, "head");
        put(write_at, 2, "..");
        EXPECT_FALSE(fs::exists(folder / "x")) << "before it is whole";
    });
    EXPECT_EQ(read_bytes(folder / "x"), "he..tail");
    EXPECT_THROW(replace_file(folder / "x",
                              [&](const WriteAt& write_at) {
                                  put(write_at, 0, "something else");
                                  throw std::runtime_error("the source ended");
                              }),
                 std::runtime_error);
    EXPECT_EQ(read_bytes(folder / "x"), "he..tail");
    EXPECT_EQ(folder.files(), 1);
}

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
