#include "core/image/picture_file.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/setting.h"
#include "core/base/version.h"
#include "core/image/jpeg.h"
#include "core/image/picture_codec.h"
#include "core/image/png.h"
#include "core/image/webp.h"

namespace vvr::image {

namespace {

constexpr std::string_view setting_prefix = "vvr:";
constexpr const char* lines_attribute = "ImageDescription";
// A JPEG segment has at most 64 KB.
constexpr std::size_t longest_description = 60'000;

/// A picture file format.
struct PictureFormat {
    std::string_view extension;
    Stored stored;
    bool alpha;       ///< supports transparency
    bool settings;    ///< supports any attribute; else the settings become lines of the description
    bool pixel_data;  ///< supports additional float channels
    int most_side;    ///< pixels; for more, the encoder would abort the program
    const PictureCodec& (*codec)();
};

constexpr int any_side = 1 << 30;

constexpr std::array picture_formats{
    PictureFormat{".png", Stored::uint8, true, true, false, most_png_side, png_codec},
    PictureFormat{".exr", Stored::half, true, true, true, any_side, openimageio_codec},
    PictureFormat{".tif", Stored::uint16, true, false, false, any_side, openimageio_codec},
    PictureFormat{".tiff", Stored::uint16, true, false, false, any_side, openimageio_codec},
    PictureFormat{".jpg", Stored::uint8, false, false, false, most_jpeg_side, jpeg_codec},
    PictureFormat{".jpeg", Stored::uint8, false, false, false, most_jpeg_side, jpeg_codec},
};

const PictureFormat& format_of(const std::filesystem::path& path) {
    const std::string extension = extension_of(path);
    const auto format = std::ranges::find(picture_formats, extension, &PictureFormat::extension);
    if (format != picture_formats.end()) return *format;
    const std::vector<std::string> known = picture_file_extensions();
    throw Error(ErrorCode::output_format_unknown,
                fmt::format("cannot write '{}': {}{}; use one of: {}", path.string(),
                            extension.empty() ? "it has no file extension"
                                              : fmt::format("the file extension '{}' is unknown", extension),
                            did_you_mean(extension, known), fmt::join(known, " ")));
}

/// The interleaved values of an 8-bit file.
/// \param channels 3, or 4 with alpha
std::vector<std::uint8_t> bytes_of(const Picture& picture, int channels) {
    std::vector<std::uint8_t> values;
    values.reserve(picture.pixels.pixels().size() * static_cast<std::size_t>(channels));
    for (const Rgba& pixel : picture.pixels.pixels()) {
        // 8-bit formats have straight alpha.
        const float over_alpha = channels == 4 && pixel.a > 0 ? 1 / pixel.a : 1;
        for (int c = 0; c < 3; ++c) values.push_back(to_byte(over_alpha * pixel[c]));
        if (channels == 4) values.push_back(to_byte(pixel.a));
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

Metadata attributes_of(const PictureFormat& format, const Metadata& metadata) {
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
PictureFile describe(const std::filesystem::path& path, const PictureFormat& format, Size size, int channels,
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
            .png_level = 2,
            .png_filter = png_filter::sub,
            .jpeg_quality = jpeg_quality};
}

}  // namespace

std::vector<std::string> picture_file_extensions() {
    std::vector<std::string> extensions;
    extensions.reserve(picture_formats.size());
    for (const PictureFormat& format : picture_formats) extensions.emplace_back(format.extension);
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
    const PictureFormat& format = format_of(path);
    const bool opaque = std::ranges::all_of(picture.pixels.pixels(), [](const Rgba& pixel) { return pixel.a >= 1; });
    const int channels = opaque || !format.alpha ? 3 : 4;
    PictureFile file = describe(path, format, picture.pixels.size(), channels, metadata, jpeg_quality);
    // TIFF would need an Exif block for it, and readers assume sRGB for its integers anyway.
    file.srgb = format.settings;
    if (format.stored == Stored::uint8) {
        const std::vector<std::uint8_t> values = bytes_of(picture, channels);
        picture = {};
        file.values = std::as_bytes(std::span(values));
        return format.codec().encode(file);
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
    return format.codec().encode(file);
}

std::vector<std::byte> encode_picture(const std::filesystem::path& path, const Plane<Bgr>& picture, int jpeg_quality) {
    Plane<Bgr> rgb = picture;
    for (Bgr& pixel : rgb.pixels()) std::swap(pixel[0], pixel[2]);
    const PictureFormat& format = format_of(path);
    PictureFile file = describe(path, format, picture.size(), 3, {}, jpeg_quality);
    file.values = std::as_bytes(rgb.pixels());
    return format.codec().encode(file);
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
