// PNGs of all kinds that libpng writes, read by vvr and by OpenImageIO.
#include "core/image/png.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <png.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/image/picture_codec.h"
#include "core/image/picture_file.h"
#include "tests/support/errors.h"
#include "tests/support/temp_folder.h"

namespace vvr {
namespace {

constexpr Size some{37, 11};

/// A kind of PNG.
struct Kind {
    int colour_type;
    int bits;
    bool interlaced = false;
    bool transparent = false;  ///< with a transparent colour, or a palette with alpha
    int side = 0;              ///< not 0: what the header says of a file that has next to no pixels
};

std::vector<Kind> all_kinds() {
    std::vector<Kind> kinds;
    for (const bool interlaced : {false, true}) {
        for (const bool transparent : {false, true}) {
            for (const int bits : {1, 2, 4, 8, 16})
                kinds.push_back({PNG_COLOR_TYPE_GRAY, bits, interlaced, transparent});
            for (const int bits : {1, 2, 4, 8})
                kinds.push_back({PNG_COLOR_TYPE_PALETTE, bits, interlaced, transparent});
            for (const int bits : {8, 16}) kinds.push_back({PNG_COLOR_TYPE_RGB, bits, interlaced, transparent});
        }
        for (const int type : {PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB_ALPHA}) {
            for (const int bits : {8, 16}) kinds.push_back({type, bits, interlaced});
        }
    }
    return kinds;
}

/// \param change what else libpng is told before the header is written
std::vector<std::byte> png_of(const Kind& kind, const std::function<void(png_structp, png_infop)>& change = {}) {
    std::vector<std::byte> file;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &file,
        [](png_structp to, png_bytep bytes, std::size_t count) {
            const auto more = std::as_bytes(std::span(bytes, count));
            auto& all = *static_cast<std::vector<std::byte>*>(png_get_io_ptr(to));
            all.insert(all.end(), more.begin(), more.end());
        },
        nullptr);
    const Size size = kind.side == 0 ? some : Size{kind.side, kind.side};
    png_set_IHDR(png, info, static_cast<png_uint_32>(size.width), static_cast<png_uint_32>(size.height), kind.bits,
                 kind.colour_type, kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (kind.colour_type == PNG_COLOR_TYPE_PALETTE) {
        std::vector<png_color> palette;
        for (int i = 0; i < 1 << kind.bits; ++i) {
            palette.push_back({static_cast<png_byte>(7 * i), static_cast<png_byte>(255 - i), static_cast<png_byte>(i)});
        }
        png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    }
    png_byte alphas[] = {10, 200};
    png_color_16 clear{1, 3, 3, 3, 1};
    if (kind.transparent) png_set_tRNS(png, info, alphas, 2, &clear);
    if (change) change(png, info);
    png_write_info(png, info);
    if (kind.side != 0) {
        const png_byte few[] = {0};
        png_write_chunk(png, reinterpret_cast<png_const_bytep>("IDAT"), few, 1);
        png_destroy_write_struct(&png, &info);
        return file;
    }
    const std::size_t row = png_get_rowbytes(png, info);
    std::vector<png_byte> values(row * some.height);
    std::uint32_t random = 1;
    for (png_byte& value : values) value = static_cast<png_byte>((random = random * 1664525 + 1013904223) >> 24U);
    if (row >= 8) std::fill_n(values.begin(), 6, png_byte{3});  // what is transparent, at 8 bits
    std::vector<png_bytep> rows;
    for (int j = 0; j < some.height; ++j) rows.push_back(values.data() + static_cast<std::size_t>(j) * row);
    png_write_image(png, rows.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return file;
}

std::vector<float> values_of(image::PictureReader& reader) {
    std::vector<float> values(static_cast<std::size_t>(reader.size.width) *
                              static_cast<std::size_t>(reader.size.height) * reader.channels.size());
    reader.read(values.data());
    return values;
}

void set_text(png_structp png, png_infop info, int compression, std::string key, std::string value) {
    png_text text{};
    text.compression = compression;
    text.key = key.data();
    text.text = value.data();
    png_set_text(png, info, &text, 1);
}

TEST(Png, OfEachKindIsReadAsByOpenImageIO) {
    for (const Kind& kind : all_kinds()) {
        SCOPED_TRACE(fmt::format("type {}, {} bits, {}, {}", kind.colour_type, kind.bits,
                                 kind.interlaced ? "interlaced" : "in order", kind.transparent ? "tRNS" : "opaque"));
        const std::vector<std::byte> file = png_of(kind);
        const auto ours = image::png_codec().open("a.png", "png", file);
        const auto theirs = image::openimageio_codec().open("a.png", "png", file);
        EXPECT_EQ(ours->size, theirs->size);
        EXPECT_EQ(ours->channels, theirs->channels);
        EXPECT_EQ(ours->straight_alpha, theirs->straight_alpha);
        EXPECT_EQ(values_of(*ours), values_of(*theirs));
    }
}

TEST(Png, HasTextsOfEachChunk) {
    const auto file = png_of({PNG_COLOR_TYPE_GRAY, 8}, [](png_structp png, png_infop info) {
        set_text(png, info, PNG_TEXT_COMPRESSION_NONE, "vvr:a", "plain");
        set_text(png, info, PNG_TEXT_COMPRESSION_zTXt, "vvr:b", std::string(100'000, 'x'));
        set_text(png, info, PNG_ITXT_COMPRESSION_NONE, "vvr:c", "Süd");
        set_text(png, info, PNG_ITXT_COMPRESSION_zTXt, "vvr:d", "日本");
        set_text(png, info, PNG_TEXT_COMPRESSION_NONE, "vvr:a", "again");
        set_text(png, info, PNG_TEXT_COMPRESSION_NONE, "Description", "vvr:e=line\nvvr:f=other\n");
    });
    const image::Metadata settings{
        {"a", "again"}, {"b", std::string(100'000, 'x')}, {"c", "Süd"}, {"d", "日本"}, {"e", "line"}, {"f", "other"}};
    EXPECT_EQ(image::settings_of(image::decode_samples("a.png", file)), settings);
}

// Their bytes are the same with the OpenImageIO of Debian 12, but not with others.
TEST(Png, SaysTheSameAsThatOfOpenImageIO) {
    std::vector<std::uint8_t> values(static_cast<std::size_t>(4 * some.width * some.height));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<std::uint8_t>(i * i / 7);
    for (const int colours : {1, 3, 4}) {
        for (const bool srgb : {false, true}) {
            image::PictureFile file{.format = "png", .name = "a.png", .size = some, .colours = colours, .srgb = srgb};
            file.attributes = {{"Software", "vvr"}, {"vvr:title", std::string(100'000, 't')}, {"vvr:empty", ""}};
            file.values = std::as_bytes(std::span(values)).first(values.size() / 4 * static_cast<std::size_t>(colours));
            SCOPED_TRACE(fmt::format("{} channels, {}", colours, srgb ? "sRGB" : "no colour space"));
            const std::vector<std::byte> our_file = image::png_codec().encode(file);
            const std::vector<std::byte> their_file = image::openimageio_codec().encode(file);
            const auto ours = image::openimageio_codec().open("ours.png", "png", our_file);
            const auto theirs = image::openimageio_codec().open("theirs.png", "png", their_file);
            EXPECT_EQ(ours->attributes(), theirs->attributes());
            EXPECT_EQ(ours->channels, theirs->channels);
            EXPECT_EQ(values_of(*ours), values_of(*theirs));
        }
    }
}

TEST(Png, ThatIsCutIsRefusedAtEachLength) {
    for (const bool interlaced : {false, true}) {
        const auto file = png_of({PNG_COLOR_TYPE_RGB, 8, interlaced});
        const std::string_view letters(reinterpret_cast<const char*>(file.data()), file.size());
        const std::size_t end = letters.find("IEND") - 4;  // whatever comes after the pixels is not needed
        for (std::size_t length = 8; length < end; length += 7) {
            test::expect_error(ErrorCode::file_invalid,
                               [&] { image::decode_samples("cut.png", std::span(file).first(length)); },
                               {"'cut.png'", "the file ends too early", "check that the file is complete"});
        }
        EXPECT_NO_THROW(image::decode_samples("cut.png", std::span(file).first(end)));
    }
}

TEST(Png, ThatIsDamagedIsRefused) {
    const auto with = [](std::string_view where, std::size_t offset) {
        auto file = png_of({PNG_COLOR_TYPE_RGB, 8});
        const std::string_view letters(reinterpret_cast<const char*>(file.data()), file.size());
        file[letters.find(where) + offset] ^= std::byte{0xFF};
        return file;
    };
    test::expect_error(ErrorCode::file_invalid, [&] { image::decode_samples("a.png", with("IHDR", 5)); },
                       {"'a.png'", "IHDR: CRC error"});
    test::expect_error(ErrorCode::file_invalid, [&] { image::decode_samples("a.png", with("IDAT", 30)); }, {"IDAT"});
}

TEST(Png, WithTooManyValuesIsRefusedBeforeItsPixelsAreRead) {
    const auto file = png_of({.colour_type = PNG_COLOR_TYPE_RGB, .bits = 8, .side = 900'000});
    test::expect_error(ErrorCode::picture_too_large, [&] { image::decode_samples("a.png", file); },
                       {"'a.png'", "900000x900000", "500 million"});
}

TEST(Png, OfAnExtractionHasOneSizeAndEightBits) {
    const test::TempFolder folder;
    std::vector<std::uint8_t> values(static_cast<std::size_t>(some.width * some.height));
    const auto read = [&](const char* name, Size size) { image::read_png_bytes(folder / name, 1, size, values); };
    const auto write = [&](const char* name, const Kind& kind) {
        const auto file = png_of(kind);
        test::write_bytes(folder / name, std::string(reinterpret_cast<const char*>(file.data()), file.size()));
    };
    write("a.png", {PNG_COLOR_TYPE_GRAY, 8});
    EXPECT_NO_THROW(read("a.png", some));
    EXPECT_EQ(values[0], 3);
    test::expect_error(ErrorCode::file_invalid, [&] { read("a.png", {11, 37}); }, {"a.png'", "37x11", "`vvr extract`"});
    write("wide.png", {PNG_COLOR_TYPE_GRAY, 16});
    test::expect_error(ErrorCode::file_invalid, [&] { read("wide.png", some); }, {"wide.png'", "uint16"});
    test::expect_error(ErrorCode::file_not_found, [&] { read("none.png", some); }, {"none.png'"});
    test::write_bytes(folder / "no.png", "no picture");
    test::expect_error(ErrorCode::file_invalid, [&] { read("no.png", some); }, {"no.png'"});
}

}  // namespace
}  // namespace vvr
