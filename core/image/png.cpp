#include "core/image/png.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <png.h>
#include <zlib.h>

#include <fmt/format.h>

#include "core/base/error.h"

namespace vvr::image {

namespace {

/// Why libpng failed.
struct Failure {
    std::array<char, 200> text{};
    bool memory = false;  ///< an allocation has failed
};

[[noreturn]] void fail(png_structp png, png_const_charp text) {
    auto& failure = *static_cast<Failure*>(png_get_error_ptr(png));
    std::snprintf(failure.text.data(), failure.text.size(), "%s", text);
    png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

void* allocate(png_structp png, png_alloc_size_t bytes) {
    void* const memory = std::malloc(bytes);  // NOLINT(cppcoreguidelines-owning-memory): libpng owns it
    if (memory == nullptr) static_cast<Failure*>(png_get_mem_ptr(png))->memory = true;
    return memory;
}

void release(png_structp, void* memory) {
    std::free(memory);  // NOLINT(cppcoreguidelines-owning-memory): libpng owns it
}

/// Calls libpng. It leaves by longjmp, so nothing from here to there may have a destructor: not the calls, nor the
/// functions that libpng calls back.
/// \returns whether it has not failed
template <class Calls>
bool succeeds(png_structp png, const Calls& calls) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT(cert-err52-cpp): libpng is C and has nothing else
    calls();
    return true;
}

// Writing

struct Encoder {
    explicit Encoder(Failure& failure)
        : png(png_create_write_struct_2(PNG_LIBPNG_VER_STRING, &failure, fail, ignore_warning, &failure, allocate,
                                        release)),
          info(png == nullptr ? nullptr : png_create_info_struct(png)) {}
    ~Encoder() { png_destroy_write_struct(&png, &info); }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;

    png_structp png;
    png_infop info;
};

bool append(std::vector<std::byte>& to, std::span<const std::byte> bytes) noexcept {
    try {
        to.insert(to.end(), bytes.begin(), bytes.end());
        return true;
    } catch (const std::bad_alloc&) {
        return false;
    }
}

void put(png_structp png, png_bytep bytes, std::size_t count) {
    if (append(*static_cast<std::vector<std::byte>*>(png_get_io_ptr(png)), std::as_bytes(std::span(bytes, count)))) {
        return;
    }
    static_cast<Failure*>(png_get_error_ptr(png))->memory = true;
    png_error(png, "out of memory");
}

void flush_nothing(png_structp) {}

/// A text of the file, which refers to `name` and `value`. A tEXt chunk is Latin-1; for other letters there is iTXt, in
/// UTF-8.
png_text chunk_of(const std::string& name, const std::string& value) {
    const bool ascii = std::ranges::none_of(value, [](char c) { return static_cast<unsigned char>(c) > 0x7F; });
    png_text text{};
    text.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    text.key = const_cast<char*>(name.c_str());    // libpng doesn't change it
    text.text = const_cast<char*>(value.c_str());  // nor this
    return text;
}

std::vector<std::byte> encode(const PictureFile& file) {
    Metadata attributes = file.attributes;
    // Readers that use OpenImageIO look for it.
    if (file.srgb) attributes.emplace_back("oiio:ColorSpace", "sRGB");
    std::vector<png_text> texts;
    texts.reserve(attributes.size());
    for (const auto& [name, value] : attributes) texts.push_back(chunk_of(name, value));

    constexpr int bits = 8;
    const int colour_type = file.colours == 1   ? PNG_COLOR_TYPE_GRAY
                            : file.colours == 4 ? PNG_COLOR_TYPE_RGB_ALPHA
                                                : PNG_COLOR_TYPE_RGB;
    const std::size_t row = static_cast<std::size_t>(file.size.width) * static_cast<std::size_t>(file.colours);
    const auto* const values = reinterpret_cast<png_const_bytep>(file.values.data());
    std::vector<std::byte> encoded;
    Failure failure;
    Encoder encoder(failure);
    if (encoder.info == nullptr) throw std::bad_alloc();
    png_structp png = encoder.png;
    png_infop info = encoder.info;
    const bool done = succeeds(png, [&] {
        png_set_write_fn(png, &encoded, put, flush_nothing);
        png_set_compression_level(png, file.png_level);
        png_set_compression_strategy(png, Z_DEFAULT_STRATEGY);
        png_set_filter(png, PNG_FILTER_TYPE_BASE, file.png_filter);
        png_set_IHDR(png, info, static_cast<png_uint_32>(file.size.width), static_cast<png_uint_32>(file.size.height),
                     bits, colour_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_set_oFFs(png, info, 0, 0, PNG_OFFSET_PIXEL);
        if (file.srgb) png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_ABSOLUTE);
        if (!texts.empty()) png_set_text(png, info, texts.data(), static_cast<int>(texts.size()));
        png_write_info(png, info);
        for (int j = 0; j < file.size.height; ++j) png_write_row(png, values + static_cast<std::size_t>(j) * row);
        png_write_end(png, info);
    });
    if (done) return encoded;
    if (failure.memory) {
        throw Error(ErrorCode::out_of_memory,
                    fmt::format("cannot encode '{}': out of memory; choose a smaller picture", file.name), {"size"});
    }
    throw Error(ErrorCode::io,
                fmt::format("cannot encode '{}': {}; choose another format", file.name, failure.text.data()));
}

// Reading

/// A file, or bytes in memory.
struct PngSource {
    std::ifstream file;
    std::optional<std::span<const std::byte>> bytes;  ///< what is left of them
};

void take(png_structp png, png_bytep to, std::size_t count) {
    auto& source = *static_cast<PngSource*>(png_get_io_ptr(png));
    if (source.bytes && count <= source.bytes->size()) {
        std::ranges::copy(source.bytes->first(count), reinterpret_cast<std::byte*>(to));
        source.bytes = source.bytes->subspan(count);
        return;
    }
    if (!source.bytes && source.file.read(reinterpret_cast<char*>(to), static_cast<std::streamsize>(count))) return;
    png_error(png, source.file.bad() ? "it can't be read" : "the file ends too early");
}

/// Adds a text. Of several with one name the last counts.
void add_text(Metadata& texts, const png_text& text) {
    // A description has settings as lines.
    const std::string_view key = text.key;
    const std::string name(key == "Description" ? "ImageDescription" : key);
    const std::string value = text.text == nullptr ? "" : text.text;
    const auto same = std::ranges::find(texts, name, &Metadata::value_type::first);
    if (same == texts.end()) {
        texts.emplace_back(name, value);
    } else {
        same->second = value;
    }
}

/// The names of OpenImageIO.
std::vector<std::string> names_of_channels(int count) {
    constexpr int grey = 1;
    constexpr int grey_alpha = 2;
    if (count == grey) return {"Y"};
    if (count == grey_alpha) return {"Y", "A"};
    std::vector<std::string> names{"R", "G", "B", "A"};
    names.resize(static_cast<std::size_t>(count));
    return names;
}

template <class Value>
void scale_to_float(std::span<const std::byte> stored, float* values) {
    // A product, as OpenImageIO has it: a quotient would differ in the last bit.
    constexpr float unit = 1.F / static_cast<float>(std::numeric_limits<Value>::max());
    const std::span from(reinterpret_cast<const Value*>(stored.data()), stored.size() / sizeof(Value));
    std::ranges::transform(from, values, [](Value value) { return static_cast<float>(value) * unit; });
}

/// A PNG file that is open.
struct Decoder {
    Decoder()
        : png(png_create_read_struct_2(PNG_LIBPNG_VER_STRING, &failure, fail, ignore_warning, &failure, allocate,
                                       release)),
          info(png == nullptr ? nullptr : png_create_info_struct(png)) {}
    ~Decoder() { png_destroy_read_struct(&png, &info, nullptr); }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;

    /// Reads the header.
    /// \returns whether it could be read; else `failure`
    bool open(const std::filesystem::path& path, std::optional<std::span<const std::byte>> bytes) {
        if (info == nullptr) throw std::bad_alloc();
        source.bytes = bytes;
        errno = 0;
        if (!bytes) source.file.open(path, std::ios::binary);
        if (!bytes && !source.file.is_open()) {
            fmt::format_to_n(failure.text.data(), failure.text.size() - 1, "{}", text_of_system_error(errno));
            return false;
        }
        // A text of 8 MB may be a few kilobytes of the file.
        constexpr int most_texts = 200;
        return succeeds(png, [&] {
            png_set_read_fn(png, &source, take);
            png_set_user_limits(png, most_png_side, most_png_side);
            png_set_chunk_cache_max(png, most_texts);
            png_read_info(png, info);
            // Palettes become colours, a transparent colour becomes alpha, and fewer bits become 8.
            png_set_expand(png);
            if (std::endian::native == std::endian::little) png_set_swap(png);
            png_set_interlace_handling(png);
            png_read_update_info(png, info);
        });
    }

    Size size() const {
        return {static_cast<int>(png_get_image_width(png, info)), static_cast<int>(png_get_image_height(png, info))};
    }
    int channels() const { return png_get_channels(png, info); }
    int bits() const { return png_get_bit_depth(png, info); }

    /// Reads all rows, in order. An interlaced picture is complete only after its last pass, so it is kept whole.
    /// \param use called with the number of a row and its values, 16 bits in the machine's order
    /// \returns whether they could be read; else `failure`
    template <class Use>
    bool each_row(const Use& use) {
        const std::size_t bytes = png_get_rowbytes(png, info);
        const bool interlaced = png_get_interlace_type(png, info) != PNG_INTERLACE_NONE;
        const int height = size().height;
        std::vector<std::byte> kept(bytes * static_cast<std::size_t>(interlaced ? height : 1));
        const auto row = [&](int j) {
            return std::span(kept).subspan(interlaced ? static_cast<std::size_t>(j) * bytes : 0, bytes);
        };
        const int passes = interlaced ? PNG_INTERLACE_ADAM7_PASSES : 1;
        for (int pass = 0; pass < passes; ++pass) {
            for (int j = 0; j < height; ++j) {
                auto* const to = reinterpret_cast<png_bytep>(row(j).data());
                if (!succeeds(png, [&] { png_read_row(png, to, nullptr); })) return false;
                if (pass == passes - 1) use(j, row(j));
            }
        }
        return true;
    }

    Failure failure{};  // first, because libpng writes to it to the end
    PngSource source{};
    png_structp png;
    png_infop info;
};

class Reader : public PictureReader {
  public:
    Reader(const std::filesystem::path& path, std::optional<std::span<const std::byte>> bytes) : path_(path) {
        if (!decoder_.open(path, bytes)) throw_unreadable();
        size = decoder_.size();
        channels = names_of_channels(decoder_.channels());
        if (channels.back() == "A") straight_alpha = channels.size() - 1;
    }

    Metadata attributes() override {
        png_textp texts = nullptr;
        const int count = png_get_text(decoder_.png, decoder_.info, &texts, nullptr);
        Metadata attributes;
        for (const png_text& text : std::span(texts, static_cast<std::size_t>(count))) add_text(attributes, text);
        return attributes;
    }

    void read(float* values) override {
        constexpr int wide = 16;
        const auto convert = decoder_.bits() == wide ? scale_to_float<std::uint16_t> : scale_to_float<std::uint8_t>;
        const std::size_t per_row = static_cast<std::size_t>(size.width) * channels.size();
        const bool done = decoder_.each_row([&](int j, std::span<const std::byte> row) {
            convert(row, values + static_cast<std::size_t>(j) * per_row);
        });
        if (!done) throw_unreadable();
    }

  private:
    [[noreturn]] void throw_unreadable() const {
        if (decoder_.failure.memory) {
            throw Error(ErrorCode::out_of_memory,
                        fmt::format("cannot read picture '{}': out of memory; choose a smaller "
                                    "picture",
                                    path_.string()));
        }
        throw Error(ErrorCode::file_invalid,
                    fmt::format("cannot read picture '{}': {}; check that the file is complete", path_.string(),
                                decoder_.failure.text.data()));
    }

    std::filesystem::path path_;
    Decoder decoder_;
};

std::unique_ptr<PictureReader> open(const std::filesystem::path& path, std::string_view,
                                    std::optional<std::span<const std::byte>> bytes) {
    return std::make_unique<Reader>(path, bytes);
}

}  // namespace

const PictureCodec& png_codec() {
    static constexpr PictureCodec codec{encode, open};
    return codec;
}

void read_png_bytes(const std::filesystem::path& path, int channels, Size size, std::span<std::uint8_t> values) {
    const auto fail = [&path](std::string_view what, ErrorCode code = ErrorCode::file_invalid) {
        throw Error(code, fmt::format("cannot read '{}': {}; run `vvr extract` again", path.string(), what));
    };
    const auto fail_to_decode = [&](const Failure& failure) {
        if (failure.memory) fail("out of memory", ErrorCode::out_of_memory);
        fail(failure.text.data());
    };
    if (!std::filesystem::exists(path)) fail("the file does not exist", ErrorCode::file_not_found);
    Decoder decoder;
    if (!decoder.open(path, std::nullopt)) fail_to_decode(decoder.failure);
    constexpr int bits = 8;
    if (decoder.size() != size || decoder.channels() != channels || decoder.bits() != bits) {
        fail(fmt::format(
            "it has {}x{} pixels with {} channel(s) of uint{}, not {}x{} pixels with {} channel(s) of uint8",
            decoder.size().width, decoder.size().height, decoder.channels(), decoder.bits(), size.width, size.height,
            channels));
    }
    const bool done = decoder.each_row([&](int j, std::span<const std::byte> row) {
        const auto to = values.subspan(static_cast<std::size_t>(j) * row.size(), row.size());
        std::ranges::copy(row, std::as_writable_bytes(to).begin());
    });
    if (!done) fail_to_decode(decoder.failure);
}

}  // namespace vvr::image
