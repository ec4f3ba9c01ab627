#include "core/image/picture_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <latch>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <dlfcn.h>

#include <fmt/format.h>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/memory.h"
#include "core/base/setting.h"
#include "core/base/version.h"
#include "core/image/picture.h"
#include "core/image/webp.h"

extern "C" {
#include <libavutil/crc.h>
#include <libavutil/intreadwrite.h>
}

namespace vvr::image {

namespace {

/// A picture format that can be read.
struct ReadFormat {
    std::string_view name;         ///< OpenImageIO's name
    std::string_view first_bytes;  ///< signature of its files
};

using namespace std::string_view_literals;
constexpr std::array read_formats{ReadFormat{"png", "\x89PNG\r\n\x1a\n"sv}, ReadFormat{"jpeg", "\xff\xd8\xff"sv},
                                  ReadFormat{"tiff", "II*\0"sv}, ReadFormat{"tiff", "MM\0*"sv},
                                  ReadFormat{"openexr", "\x76\x2f\x31\x01"sv}};

constexpr std::size_t longest_begin = 8;

/// \param begin first bytes of the file
std::string_view format_of(const std::filesystem::path& name, std::string_view begin) {
    const auto format =
        std::ranges::find_if(read_formats, [&](const ReadFormat& row) { return begin.starts_with(row.first_bytes); });
    if (format != read_formats.end()) return format->name;
    throw Error(ErrorCode::file_invalid,
                fmt::format("cannot read picture '{}': {}", name.string(),
                            begin.empty() ? "the file is empty; give another file"
                                          : "the content is not PNG, JPEG, TIFF or OpenEXR; convert the file"));
}

/// The format of a file, by its first bytes.
std::string_view format_of_file(const std::filesystem::path& path) {
    check_is_file(path.string(), most_bytes::data);
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::array<char, longest_begin> begin{};
    file.read(begin.data(), begin.size());
    if (!file.is_open() || file.bad()) {
        throw system_error(errno, fmt::format("cannot read picture '{}'", path.string()),
                           "check its name and permissions");
    }
    const std::string_view bytes(begin.data(), static_cast<std::size_t>(file.gcount()));
    return format_of(path, bytes);
}

}  // namespace

Samples read_samples(const std::filesystem::path& path) {
    return picture_codec().read(path, format_of_file(path), std::nullopt);
}

Plane<float> read_grey_samples(const std::filesystem::path& path, Size size) {
    auto plane = Plane<float>::for_overwrite(size);
    picture_codec().read_grey(path, format_of_file(path), size, plane.pixels().data());
    return plane;
}

Samples decode_samples(const std::filesystem::path& name, std::span<const std::byte> bytes) {
    const std::string_view begin(reinterpret_cast<const char*>(bytes.data()), std::min(longest_begin, bytes.size()));
    return picture_codec().read(name, format_of(name, begin), bytes);
}

Samples without_pixel_data(Samples samples) {
    const auto is_pixel_data = [](const std::string& channel) {
        return std::ranges::find(pixel_data_channels, channel, &PixelDataChannel::name) != pixel_data_channels.end();
    };
    if (std::ranges::none_of(samples.channels, is_pixel_data)) return samples;
    std::vector<float> kept;
    for (std::size_t i = 0; i < samples.values.size(); ++i) {
        if (!is_pixel_data(samples.channels[i % samples.channels.size()])) kept.push_back(samples.values[i]);
    }
    samples.values = std::move(kept);
    std::erase_if(samples.channels, is_pixel_data);
    return samples;
}

namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr int search = 0;  // AddressSanitizer doesn't support RTLD_DEEPBIND
#else
// Its 250 libraries then resolve symbols among themselves first, not in the program's 150 libraries: half the time.
constexpr int search = RTLD_DEEPBIND;
#endif

/// Checks that threads can be started. One of the dependencies, log4cplus, starts a thread per core when loaded, and
/// at least four. If that fails, it aborts or hangs.
/// \throws std::system_error if the threads can't be started
void check_threads() {
    const unsigned wanted = std::max(4U, std::thread::hardware_concurrency());
    std::latch all_there(1);
    std::vector<std::jthread> threads;
    threads.reserve(wanted);
    try {
        for (unsigned i = 0; i < wanted; ++i) threads.emplace_back([&] { all_there.wait(); });
    } catch (...) {
        all_there.count_down();
        throw;
    }
    all_there.count_down();
}

const PictureCodec& load() {
    check_threads();
    // Never closed, because some of the dependencies crash when unloaded.
    constexpr int how = RTLD_LAZY | RTLD_LOCAL | RTLD_NODELETE | search;
    void* const library = while_loading([] { return dlopen(VVR_PICTURE_CODEC, how); });
    void* const codec = library ? dlsym(library, picture_codec_symbol) : nullptr;
    if (codec) return *reinterpret_cast<const PictureCodec* (*)()>(codec)();
    const char* const why = dlerror();
    const std::string text = why == nullptr ? "" : why;
    // Includes the 250 dependencies.
    constexpr std::int64_t bytes_of_all = 200'000'000;
    const bool short_of_memory =
        std::ranges::any_of(std::array{"allocate memory", "failed to map segment", "out of memory"},
                            [&](const char* words) { return text.find(words) != std::string::npos; });
    if (short_of_memory || !is_memory_available(bytes_of_all)) {
        throw Error(
            ErrorCode::out_of_memory,
            fmt::format("out of memory while loading the library for picture files: {}; give vvr more memory", text));
    }
    throw Error(ErrorCode::io, fmt::format("cannot load the library for picture files: {}; reinstall vvr", text));
}

}  // namespace

const PictureCodec& picture_codec() {
    static const PictureCodec& codec = load();
    return codec;
}

namespace {

using Bytes = std::span<const std::byte>;

constexpr std::size_t signature = 8;
constexpr std::size_t word = 4;  // bytes of a chunk's length, type and checksum, each

const std::uint8_t* raw(Bytes bytes) {
    return reinterpret_cast<const std::uint8_t*>(bytes.data());
}

void append(std::vector<std::byte>& to, Bytes bytes) {
    to.insert(to.end(), bytes.begin(), bytes.end());
}

void append_number(std::vector<std::byte>& to, std::size_t number) {
    for (const int shift : {24, 16, 8, 0}) to.push_back(static_cast<std::byte>(number >> shift));
}

/// Appends an iTXt chunk.
/// \param text keyword, a zero byte and the text
void append_utf8_chunk(std::vector<std::byte>& to, Bytes text) {
    using namespace std::literals;
    const auto key_end = std::ranges::find(text, std::byte{0});
    std::vector<std::byte> chunk;
    append(chunk, std::as_bytes(std::span("iTXt"sv)));
    append(chunk, {text.begin(), key_end});
    append(chunk, std::as_bytes(std::span("\0\0\0\0\0"sv)));  // not compressed, no language, no translated keyword
    append(chunk, {key_end + 1, text.end()});
    append_number(to, chunk.size() - word);
    append(to, chunk);
    append_number(to, ~av_crc(av_crc_get_table(AV_CRC_32_IEEE_LE), ~0U, raw(chunk), chunk.size()));
}

/// Converts a PNG file's texts beyond ASCII to iTXt chunks, which are UTF-8. OpenImageIO writes only tEXt chunks, which
/// readers decode as Latin-1.
std::vector<std::byte> with_utf8_texts(const std::vector<std::byte>& png) {
    const Bytes whole(png);
    std::vector<std::byte> marked(png.begin(), png.begin() + signature);
    for (Bytes left = whole.subspan(signature); !left.empty();) {
        const std::size_t length = AV_RB32(raw(left));
        const Bytes chunk = left.first(word + word + length + word);
        const Bytes text = chunk.subspan(word + word, length);
        const bool is_text = std::ranges::equal(chunk.subspan(word, word), std::as_bytes(std::span("tEXt", word)));
        if (is_text && std::ranges::any_of(text, [](std::byte byte) { return byte > std::byte{0x7F}; })) {
            append_utf8_chunk(marked, text);
        } else {
            append(marked, chunk);
        }
        left = left.subspan(chunk.size());
    }
    return marked;
}

constexpr std::string_view setting_prefix = "vvr:";
constexpr const char* lines_attribute = "ImageDescription";
// A JPEG segment has at most 64 KB, and libjpeg aborts the program for a longer text.
constexpr std::size_t longest_description = 60'000;

/// A picture file format.
struct Format {
    std::string_view extension;
    Stored stored;
    bool alpha;       ///< supports transparency
    bool settings;    ///< supports any attribute; else the settings become lines of the description
    bool pixel_data;  ///< supports additional float channels
    int most_side;    ///< pixels; for more, the encoder would abort the program
    /// Post-processes the encoded bytes of an 8-bit file; null = none.
    std::vector<std::byte> (*finished)(const std::vector<std::byte>&);
};

constexpr int any_side = 1 << 30;

constexpr std::array formats{
    Format{".png", Stored::uint8, true, true, false, any_side, with_utf8_texts},
    Format{".exr", Stored::half, true, true, true, any_side, nullptr},
    Format{".tif", Stored::uint16, true, false, false, any_side, nullptr},
    Format{".tiff", Stored::uint16, true, false, false, any_side, nullptr},
    Format{".jpg", Stored::uint8, false, false, false, 65500, nullptr},
    Format{".jpeg", Stored::uint8, false, false, false, 65500, nullptr},
};

const Format& format_of(const std::filesystem::path& path) {
    const std::string extension = extension_of(path);
    const auto format = std::ranges::find(formats, extension, &Format::extension);
    if (format != formats.end()) return *format;
    const std::vector<std::string> known = picture_file_extensions();
    throw Error(ErrorCode::output_format_unknown,
                fmt::format("cannot write '{}': {}{}; use one of: {}", path.string(),
                            extension.empty() ? "it has no file extension"
                                              : fmt::format("the file extension '{}' is unknown", extension),
                            did_you_mean(extension, known), fmt::join(known, " ")));
}

std::uint8_t byte_of(float value) {
    constexpr float to_nearest = 0.5F;  // std::lround takes five times as long
    // Maps NaN to 0; std::clamp would not.
    return static_cast<std::uint8_t>(255 * std::min(std::max(0.F, value), 1.F) + to_nearest);
}

/// The interleaved values of an 8-bit file.
/// \param channels 3, or 4 with alpha
std::vector<std::uint8_t> bytes_of(const Picture& picture, int channels) {
    std::vector<std::uint8_t> values;
    values.reserve(picture.pixels.pixels().size() * static_cast<std::size_t>(channels));
    for (const Rgba& pixel : picture.pixels.pixels()) {
        // 8-bit formats have straight alpha.
        const float over_alpha = channels == 4 && pixel.a > 0 ? 1 / pixel.a : 1;
        for (int c = 0; c < 3; ++c) values.push_back(byte_of(over_alpha * pixel[c]));
        if (channels == 4) values.push_back(byte_of(pixel.a));
    }
    return values;
}

/// The interleaved values of a float file: `channels` of colour and alpha, followed by `pixel_data` unless it is empty.
std::vector<float> floats_of(const Picture& picture, int channels, const PixelData& pixel_data) {
    const auto pixels = picture.pixels.pixels();
    std::vector<float> values;
    values.reserve(pixels.size() * (static_cast<std::size_t>(channels) + pixel_data_channels.size()));
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        for (int c = 0; c < channels; ++c) values.push_back(pixels[i][c]);
        if (pixel_data.empty()) continue;
        for (const PixelDataChannel& channel : pixel_data_channels) {
            const Plane<float>& plane = pixel_data.*channel.plane;
            if (!plane.empty()) values.push_back(plane.pixels()[i]);
        }
    }
    return values;
}

Metadata attributes_of(const Format& format, const Metadata& metadata) {
    Metadata attributes{{"Software", fmt::format("vvr {}", version())}};
    std::string lines;
    for (const auto& [name, value] : metadata) {
        const std::string full_name = fmt::format("{}{}", setting_prefix, name);
        if (format.settings) attributes.emplace_back(full_name, value);
        lines += fmt::format("{}={}\n", full_name, value);
    }
    if (!format.settings && !lines.empty()) {
        attributes.emplace_back(lines_attribute, lines.substr(0, longest_description));
    }
    return attributes;
}

/// A picture file without its values.
PictureFile describe(const std::filesystem::path& path, const Format& format, Size size, int channels,
                     const Metadata& metadata, int jpeg_quality) {
    if (std::max(size.width, size.height) > format.most_side) {
        throw Error(ErrorCode::io,
                    fmt::format("cannot encode '{}' of {}x{} pixels: a {} file has at most {} pixels per side; "
                                "choose a smaller size or another format",
                                path.string(), size.width, size.height, format.extension, format.most_side));
    }
    return {.format = std::string(format.extension.substr(1)),
            .name = path.string(),
            .size = size,
            .colours = channels,
            .stored = format.stored,
            .attributes = attributes_of(format, metadata),
            .options = {
                {"png:compressionLevel", 2}, {"png:filter", png_filter::sub}, {"CompressionQuality", jpeg_quality}}};
}

}  // namespace

std::vector<std::string> picture_file_extensions() {
    std::vector<std::string> extensions;
    extensions.reserve(formats.size());
    for (const Format& format : formats) extensions.emplace_back(format.extension);
    return extensions;
}

bool holds_pixel_data(const std::filesystem::path& path) {
    return format_of(path).pixel_data;
}

void check_picture_extension(const std::filesystem::path& path) {
    format_of(path);
}

void check_picture_path(const std::filesystem::path& path) {
    check_picture_extension(path);
    check_file_path(path);
}

std::vector<std::byte> encode_picture(const std::filesystem::path& path, Picture picture, const Metadata& metadata,
                                      int jpeg_quality) {
    const Format& format = format_of(path);
    const bool opaque = std::ranges::all_of(picture.pixels.pixels(), [](const Rgba& pixel) { return pixel.a >= 1; });
    const int channels = opaque || !format.alpha ? 3 : 4;
    PictureFile file = describe(path, format, picture.pixels.size(), channels, metadata, jpeg_quality);
    // TIFF would need an Exif block for it, and readers assume sRGB for its integers anyway.
    if (format.settings) file.attributes.emplace_back("oiio:ColorSpace", "sRGB");
    if (format.stored == Stored::uint8) {
        const std::vector<std::uint8_t> values = bytes_of(picture, channels);
        picture = {};
        file.values = std::as_bytes(std::span(values));
        std::vector<std::byte> encoded = picture_codec().encode(file);
        return format.finished != nullptr ? format.finished(encoded) : encoded;
    }
    file.attributes.emplace_back("Compression", "zip");
    const PixelData none;
    const PixelData& pixel_data = format.pixel_data ? picture.pixel_data : none;
    if (!pixel_data.empty()) {
        for (const PixelDataChannel& channel : pixel_data_channels) {
            if (!(pixel_data.*channel.plane).empty()) file.pixel_data.emplace_back(channel.name);
        }
    }
    const std::vector<float> values = floats_of(picture, channels, pixel_data);
    picture = {};
    file.values = std::as_bytes(std::span(values));
    return picture_codec().encode(file);
}

std::vector<std::byte> encode_picture(const std::filesystem::path& path, const Plane<Bgr>& picture, int jpeg_quality) {
    Plane<Bgr> rgb = picture;
    for (Bgr& pixel : rgb.pixels()) std::swap(pixel[0], pixel[2]);
    PictureFile file = describe(path, format_of(path), picture.size(), 3, {}, jpeg_quality);
    file.values = std::as_bytes(rgb.pixels());
    return picture_codec().encode(file);
}

std::vector<std::byte> encode_webp(const Plane<Rgba>& pixels, int quality) {
    return encode_webp(bytes_of({pixels}, 4), pixels.size(), quality);
}

void write_picture(const std::filesystem::path& path, Picture picture, const Metadata& metadata) {
    // Encoded in memory, so that our own checked write detects a full disk.
    replace_file(path, encode_picture(path, std::move(picture), metadata));
}

Metadata settings_of(const Samples& file) {
    Metadata settings;
    std::istringstream description;
    for (const auto& [name, value] : file.attributes) {
        if (name.starts_with(setting_prefix)) settings.emplace_back(name.substr(setting_prefix.size()), value);
        if (name == lines_attribute) description.str(value);
    }
    for (std::string line; std::getline(description, line);) {
        const auto equals = line.find('=');
        if (line.starts_with(setting_prefix) && equals != std::string::npos) {
            settings.emplace_back(line.substr(setting_prefix.size(), equals - setting_prefix.size()),
                                  line.substr(equals + 1));
        }
    }
    return settings;
}

}  // namespace vvr::image
