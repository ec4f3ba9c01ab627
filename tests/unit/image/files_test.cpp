#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
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

#include <gtest/gtest.h>

#include "core/base/atomic_file.h"
#include "core/base/digest.h"
#include "core/base/error.h"
#include "core/image/picture.h"
#include "core/image/picture_file.h"
#include "core/image/video_encoder.h"

namespace vvr {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// A folder of its own for each test, gone at the end.
class ImageTest : public testing::Test {
  protected:
    ImageTest() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        std::string name = std::string(test->name()) + "-" + std::to_string(::getpid());
        std::ranges::replace(name, '/', '-');
        folder_ = fs::temp_directory_path() / ("vvr-image-" + name);
        fs::create_directories(folder_);
    }
    ~ImageTest() override { fs::remove_all(folder_); }
    ImageTest(const ImageTest&) = delete;
    ImageTest& operator=(const ImageTest&) = delete;

    fs::path file(const std::string& name) const { return folder_ / name; }

    std::size_t files() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

  private:
    fs::path folder_;
};

class ImageFormatTest : public ImageTest, public testing::WithParamInterface<std::string> {};

image::Picture gradient(Size size, float alpha = 1) {
    image::Picture picture{Plane<image::Rgba>(size)};
    for (int j = 0; j < size.height; ++j) {
        for (int i = 0; i < size.width; ++i) {
            const float x = static_cast<float>(i) / static_cast<float>(size.width);
            const float y = static_cast<float>(j) / static_cast<float>(size.height);
            picture.pixels.at(i, j) = {x * alpha, y * alpha, 0.25F * alpha, alpha};
        }
    }
    return picture;
}

std::string bytes(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Runs `action` and gives the error that it throws.
template <class Action>
Error error_of(Action action) {
    try {
        action();
    } catch (const Error& error) {
        return error;
    }
    return Error(ErrorCode::usage, "nothing was thrown");
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

void expect_text(const Error& error, const std::string& part) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
}

TEST_P(ImageFormatTest, ComesBackWithItsSettings) {
    const image::Picture picture = gradient({64, 48});
    const image::Metadata metadata{{"size", "64x48"}, {"camera", "-20,25"}, {"show", "volume,arrows"}};
    image::write_picture(file("a" + GetParam()), picture, metadata);

    EXPECT_LT(apart(picture, read_picture(file("a" + GetParam()))),
              GetParam().starts_with(".jp") ? 0.05 : 0.5001 / 255);
    image::Metadata read = image::settings_of(image::read_samples(file("a" + GetParam())));
    std::ranges::sort(read);
    EXPECT_EQ(read, (image::Metadata{{"camera", "-20,25"}, {"show", "volume,arrows"}, {"size", "64x48"}}));
    EXPECT_EQ(files(), 1U);
}

TEST_P(ImageFormatTest, SameBytesAtAnotherTime) {
    image::write_picture(file("a" + GetParam()), gradient({32, 16}), {{"step", "1"}});
    ::sleep(1);  // dates in pictures count seconds
    image::write_picture(file("b" + GetParam()), gradient({32, 16}), {{"step", "1"}});
    EXPECT_EQ(bytes(file("a" + GetParam())), bytes(file("b" + GetParam())));
}

TEST_P(ImageFormatTest, FullDiskLeavesNothing) {
    const auto old_action = std::signal(SIGXFSZ, SIG_IGN);
    rlimit old_limit{};
    getrlimit(RLIMIT_FSIZE, &old_limit);
    const rlimit limit{100, old_limit.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
    const Error error = error_of([&] { image::write_picture(file("a" + GetParam()), gradient({64, 48})); });
    setrlimit(RLIMIT_FSIZE, &old_limit);
    std::signal(SIGXFSZ, old_action);

    EXPECT_EQ(error.code(), ErrorCode::disk_full);
    EXPECT_EQ(files(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Formats, ImageFormatTest, testing::ValuesIn(image::picture_file_extensions()),
                         [](const auto& format) { return format.param.substr(1); });

TEST_F(ImageTest, AlphaIsKeptWhereTheFormatHasIt) {
    const image::Picture picture = gradient({16, 16}, 0.5F);
    for (const std::string name : {"a.png", "a.tif", "a.exr"}) {
        image::write_picture(file(name), picture);
        EXPECT_LT(apart(picture, read_picture(file(name))), 1.01 / 255) << name;
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
        image::write_picture(file("a.exr"), picture);
        const image::Picture read = read_picture(file("a.exr"));
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
        image::write_picture(file("b.exr"), picture);
        const image::Picture with_objects = read_picture(file("b.exr"));
        ASSERT_EQ(with_objects.pixel_data.object.size(), picture.pixels.size());
        EXPECT_EQ(with_objects.pixel_data.object.at(2, 1), 65'535);
        EXPECT_EQ(with_objects.pixel_data.object.at(0, 0), 0);
        EXPECT_EQ(with_objects.pixel_data.frame.at(4, 1), 2159999);

        image::write_picture(file("a.png"), picture);
        EXPECT_TRUE(read_picture(file("a.png")).pixel_data.empty());
    }
    EXPECT_TRUE(image::holds_pixel_data("out.EXR"));
    EXPECT_FALSE(image::holds_pixel_data("out.tif"));
}

TEST_F(ImageTest, ReplacesAsAWholeAndFollowsLinks) {
    image::write_picture(file("a.png"), gradient({8, 8}));
    fs::create_symlink(file("a.png"), file("link.png"));
    image::write_picture(file("link.png"), gradient({16, 8}));
    EXPECT_TRUE(fs::is_symlink(file("link.png")));
    EXPECT_EQ(read_picture(file("a.png")).pixels.size(), (Size{16, 8}));
    EXPECT_EQ(files(), 2U);
}

TEST_F(ImageTest, EndingsInCapitalsCount) {
    EXPECT_NO_THROW(image::check_picture_path(file("A.PNG")));
}

TEST_F(ImageTest, ReadingWhatIsNoPictureSaysSo) {
    std::ofstream(file("text.png")) << "not a picture";
    EXPECT_EQ(error_of([&] { read_picture(file("text.png")); }).code(), ErrorCode::file_invalid);
    expect_text(error_of([&] { read_picture(file("none.png")); }), "none.png");
}

TEST_F(ImageTest, RemovesWhatAKilledProgramLeft) {
    const auto part = [&](int number) {
        char name[64];
        std::snprintf(name, sizeof name, ".vvr-%016lx-%d.part", static_cast<unsigned long>(fnv1a("x")), number);
        return file(name);
    };
    const auto leave = [&](int number) {
        std::ofstream(part(number)) << "half";
        fs::last_write_time(part(number), fs::file_time_type::clock::now() - 61min);
    };
    const auto replace = [&](const std::string& text) {
        replace_file(file("x"), std::as_bytes(std::span(text)));
        EXPECT_EQ(bytes(file("x")), text);
    };
    leave(0);
    leave(1);
    replace("first");
    EXPECT_EQ(files(), 1) << "two that were left";
    leave(0);
    const int writer = ::open(part(0).c_str(), O_WRONLY);
    ASSERT_EQ(::flock(writer, LOCK_EX), 0);
    replace("second");
    const std::vector<std::string> names{"x"};
    remove_leftovers(file("."), names);
    EXPECT_EQ(bytes(part(0)), "half") << "somebody is writing it";
    ::close(writer);
    check_file_path(file("x"));
    EXPECT_EQ(files(), 1);
    std::ofstream(part(0)) << "half";
    remove_leftovers(file("."), names);
    EXPECT_EQ(files(), 1) << "young, but known to be nobody's";
}

TEST_F(ImageTest, WritesThroughNoLinkThatLeadsRound) {
    fs::create_symlink("round", file("round"));
    const std::string text = "text";
    const Error error = error_of([&] { replace_file(file("round"), std::as_bytes(std::span(text))); });
    EXPECT_EQ(error.kind(), ErrorKind::io);
    EXPECT_EQ(files(), 1);
}

TEST_F(ImageTest, WritesAFileInPiecesAtAnyPlace) {
    const auto put = [](const WriteAt& write_at, std::int64_t offset, std::string_view text) {
        write_at(offset, std::as_bytes(std::span(text)));
    };
    replace_file(file("x"), [&](const WriteAt& write_at) {
        put(write_at, 4, "tail");
        put(write_at, 0, "head");
        put(write_at, 2, "..");
        EXPECT_FALSE(fs::exists(file("x"))) << "before it is whole";
    });
    EXPECT_EQ(bytes(file("x")), "he..tail");
    EXPECT_THROW(replace_file(file("x"),
                              [&](const WriteAt& write_at) {
                                  put(write_at, 0, "something else");
                                  throw std::runtime_error("the source ended");
                              }),
                 std::runtime_error);
    EXPECT_EQ(bytes(file("x")), "he..tail");
    EXPECT_EQ(files(), 1);
}

TEST_F(ImageTest, AFilmInAFileIsThatInMemory) {
    const image::VideoFormat format{"mp4", "mpeg4", "b=1000000"};
    const auto shade = [](int k) { return Plane<Bgr>({32, 16}, Bgr{40, 80, static_cast<std::uint8_t>(20 * k)}); };
    image::VideoEncoder memory(format, "a", {32, 16}, 10, 10, 5);
    for (int k = 0; k < 8; ++k) memory.add(shade(k), k);
    const std::vector<std::byte> wanted = memory.finish();
    EXPECT_EQ(memory.bytes(), wanted.size());
    replace_file(file("film"), [&](const WriteAt& write_at) {
        image::VideoEncoder film(format, "a", {32, 16}, 10, 10, 5, write_at);
        for (int k = 0; k < 8; ++k) film.add(shade(k), k);
        EXPECT_TRUE(film.finish().empty());
    });
    EXPECT_EQ(bytes(file("film")), std::string(reinterpret_cast<const char*>(wanted.data()), wanted.size()));
}

TEST_F(ImageTest, WhatAFilmsFileThrowsComesThrough) {
    const auto full = [](std::int64_t, std::span<const std::byte>) {
        throw Error(ErrorCode::disk_full, "the disk is full");
    };
    const Error error = error_of([&] {
        image::VideoEncoder film({"mp4", "mpeg4", ""}, "a", {32, 16}, 10, 10, 5, full);
        film.add(Plane<Bgr>({32, 16}), 0);
        film.finish();
    });
    EXPECT_EQ(error.code(), ErrorCode::disk_full);
}

}  // namespace
}  // namespace vvr
