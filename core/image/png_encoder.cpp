#include "core/image/png_encoder.h"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstddef>
#include <new>
#include <string>

#include <png.h>

#include <fmt/format.h>

#include "core/error.h"

namespace vvr {
namespace {

struct ColourType {
    int channels;
    int type;
};
constexpr std::array colour_types{ColourType{1, PNG_COLOR_TYPE_GRAY}, ColourType{3, PNG_COLOR_TYPE_RGB},
                                  ColourType{4, PNG_COLOR_TYPE_RGB_ALPHA}};

/// libpng's writer, which says what is wrong and gives up by a long jump.
class Writer {
  public:
    Writer() : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, this, &Writer::give_up, &Writer::warn)) {
        if (png_) info_ = png_create_info_struct(png_);
        if (!info_) {
            png_destroy_write_struct(&png_, nullptr);
            throw Error(ErrorKind::limit, "out of memory for encoding a PNG file");
        }
    }
    ~Writer() { png_destroy_write_struct(&png_, &info_); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    std::vector<unsigned char> write(const PngImage& image, std::span<png_text> texts) {
        if (!try_to_write(image, texts)) {
            throw Error(
                out_of_memory_ ? ErrorKind::limit : ErrorKind::io,
                fmt::format("cannot encode a PNG file of {}x{}: {}", image.size.width, image.size.height, message_));
        }
        return std::move(bytes_);
    }

  private:
    /// Nothing in here has a destructor, for the jump would pass it by.
    bool try_to_write(const PngImage& image, std::span<png_text> texts) {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;
        png_set_write_fn(png_, this, &Writer::take, nullptr);
        png_set_compression_level(png_, image.level);
        png_set_filter(png_, PNG_FILTER_TYPE_BASE, image.filter == PngFilter::sub ? PNG_FILTER_SUB : PNG_FILTER_NONE);
        const auto width = static_cast<png_uint_32>(image.size.width);
        const auto height = static_cast<png_uint_32>(image.size.height);
        const auto* const colour = std::ranges::find(colour_types, image.channels, &ColourType::channels);
        png_set_IHDR(png_, info_, width, height, 8, colour->type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                     PNG_FILTER_TYPE_DEFAULT);
        png_set_sRGB_gAMA_and_cHRM(png_, info_, PNG_sRGB_INTENT_PERCEPTUAL);
        png_set_text(png_, info_, texts.data(), static_cast<int>(texts.size()));
        png_write_info(png_, info_);
        const std::size_t stride = static_cast<std::size_t>(image.channels) * width;
        for (std::size_t j = 0; j < height; ++j) png_write_row(png_, image.values.data() + j * stride);
        png_write_end(png_, nullptr);
        return true;
    }

    static void take(png_structp png, png_bytep data, std::size_t count) {
        auto* const writer = static_cast<Writer*>(png_get_io_ptr(png));
        try {
            writer->bytes_.insert(writer->bytes_.end(), data, data + count);
            return;
        } catch (const std::bad_alloc&) {
            writer->out_of_memory_ = true;
        }
        png_error(png, "out of memory");
    }

    [[noreturn]] static void give_up(png_structp png, png_const_charp message) {
        static_cast<Writer*>(png_get_error_ptr(png))->message_ = message;
        png_longjmp(png, 1);
    }
    static void warn(png_structp, png_const_charp) {}

    std::vector<unsigned char> bytes_;
    std::string message_;
    bool out_of_memory_ = false;
    png_structp png_;
    png_infop info_ = nullptr;
};

bool is_ascii(const std::string& text) {
    return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

/// The plain kind of text is in Latin-1, the international kind in UTF-8.
png_text text_of(const Metadata::value_type& named) {
    png_text text{};
    text.compression = is_ascii(named.second) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    // libpng takes no const text, and writes none of it.
    text.key = const_cast<char*>(named.first.c_str());
    text.text = const_cast<char*>(named.second.c_str());
    return text;
}

}  // namespace

std::vector<unsigned char> encode_png(const PngImage& image) {
    std::vector<png_text> texts;
    std::ranges::transform(image.texts, std::back_inserter(texts), text_of);
    return Writer().write(image, texts);
}

}  // namespace vvr
