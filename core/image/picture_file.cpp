#include "core/image/picture_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <span>
#include <sstream>

#include <fmt/format.h>

#include "core/error.h"
#include "core/image/atomic_file.h"
#include "core/image/codec.h"
#include "core/image/jpeg_encoder.h"
#include "core/image/layer_channels.h"
#include "core/image/png_encoder.h"
#include "core/image/samples.h"
#include "core/suggest.h"
#include "core/version.h"

namespace vvr {

namespace {

constexpr std::string_view setting_prefix = "vvr:";
constexpr const char* lines_attribute = "ImageDescription";

struct Format;

/// A picture on its way to a file, and what goes with it.
struct Job {
    const Format& format;
    const std::filesystem::path& path;
    const Picture& picture;
    const Metadata& metadata;
    int jpeg_quality;
    int channels;  ///< 3, or 4 with alpha
};

std::vector<unsigned char> as_png(const Job& job);
std::vector<unsigned char> as_jpeg(const Job& job);
std::vector<unsigned char> by_library(const Job& job);

/// One kind of picture file.
struct Format {
    std::string_view ending;
    std::vector<unsigned char> (*encode)(const Job& job);
    Stored stored;
    bool alpha;     ///< holds transparency
    bool settings;  ///< holds attributes of any name; else the settings become lines of the description
    bool layers;    ///< holds further channels of floats
};

constexpr std::array formats{
    Format{".png", as_png, Stored::uint8, true, true, false},
    Format{".exr", by_library, Stored::half, true, true, true},
    Format{".tif", by_library, Stored::uint16, true, false, false},
    Format{".tiff", by_library, Stored::uint16, true, false, false},
    Format{".jpg", as_jpeg, Stored::uint8, false, false, false},
    Format{".jpeg", as_jpeg, Stored::uint8, false, false, false},
};

const Format& format_of(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto format = std::ranges::find(formats, ending, &Format::ending);
    if (format != formats.end()) return *format;
    const std::vector<std::string> known = picture_endings();
    throw Error(ErrorKind::usage,
                fmt::format("cannot write '{}': {} is not an output format{}; there are {}", path.string(),
                            ending.empty() ? "a name without an ending" : "'" + ending + "'",
                            did_you_mean(ending, known), fmt::join(known, " ")));
}

float linear_to_srgb(float value) {
    if (value <= 0.0031308F) return value >= 0 ? 12.92F * value : 0;
    return 1.055F * std::pow(value, 1 / 2.4F) - 0.055F;
}

/// A linear pixel in sRGB, its colours still multiplied by alpha.
Rgba in_srgb(Rgba pixel) {
    if (pixel.a <= 0) return pixel;
    for (int c = 0; c < 3; ++c) pixel[c] = linear_to_srgb(pixel[c] / pixel.a) * pixel.a;
    return pixel;
}

/// The colours' values as the file wants them, without alpha where `channels` is 3.
std::vector<float> file_values(const Picture& picture, const Format& format, int channels) {
    const bool encode = picture.encoding == Encoding::linear && format.stored != Stored::half;
    std::vector<float> values;
    values.reserve(picture.pixels.pixels().size() * static_cast<std::size_t>(channels));
    for (Rgba pixel : picture.pixels.pixels()) {
        if (encode) pixel = in_srgb(pixel);
        for (int c = 0; c < channels; ++c) values.push_back(pixel[c]);
    }
    return values;
}

/// The values of all channels, pixel by pixel: `channels` of colour, and the layers after them.
std::vector<float> with_layers(const std::vector<float>& colours, int channels, const PictureLayers& layers) {
    std::vector<float> values;
    const auto count = static_cast<std::size_t>(channels);
    values.reserve(colours.size() / count * (count + layer_channels.size()));
    for (std::size_t i = 0; i < colours.size() / count; ++i) {
        const auto colour = std::span(colours).subspan(i * count, count);
        values.insert(values.end(), colour.begin(), colour.end());
        for (const LayerChannel& channel : layer_channels) values.push_back((layers.*channel.plane).pixels()[i]);
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
    if (!format.settings && !lines.empty()) attributes.emplace_back(lines_attribute, lines);
    return attributes;
}

std::vector<unsigned char> by_library(const Job& job) {
    const Format& format = job.format;
    std::vector<float> values = file_values(job.picture, format, job.channels);
    PictureFile file{.format = std::string(format.ending.substr(1)),
                     .name = job.path.string(),
                     .size = job.picture.pixels.size(),
                     .colours = job.channels,
                     .stored = format.stored};
    if (format.layers && !job.picture.layers.empty()) {
        values = with_layers(values, job.channels, job.picture.layers);
        for (const LayerChannel& channel : layer_channels) file.layers.emplace_back(channel.name);
    }
    file.values = values;
    const bool linear = job.picture.encoding == Encoding::linear && format.stored == Stored::half;
    file.attributes = attributes_of(format, job.metadata);
    file.attributes.emplace_back("Compression", "zip");
    // Without a date of its own OpenImageIO writes the current time: same input, other bytes.
    file.attributes.emplace_back("DateTime", "");
    // TIFF would need an Exif block to say it, and integers in it are taken for sRGB anyway.
    if (format.settings) file.attributes.emplace_back("oiio:ColorSpace", linear ? "Linear" : "sRGB");
    return picture_codec().encode(file);
}

std::uint8_t byte_of(float value) {
    // Not clamp: of a value that is no number it makes no number.
    return static_cast<std::uint8_t>(255 * std::min(std::max(0.F, value), 1.F) + 0.5F);
}

/// The 8-bit values of a file, pixel by pixel.
std::vector<std::uint8_t> bytes_of(const Job& job) {
    const auto pixels = job.picture.pixels.pixels();
    const auto channels = static_cast<std::size_t>(job.channels);
    const bool encode = job.picture.encoding == Encoding::linear;
    std::vector<std::uint8_t> values(channels * pixels.size());
    std::uint8_t* out = values.data();
    for (Rgba pixel : pixels) {
        if (encode) pixel = in_srgb(pixel);
        // Where a file holds alpha, its colours are not multiplied by it.
        const float over_alpha = channels == 4 && pixel.a > 0 ? 1 / pixel.a : 1;
        for (int c = 0; c < 3; ++c) *out++ = byte_of(over_alpha * pixel[c]);
        if (channels == 4) *out++ = byte_of(pixel.a);
    }
    return values;
}

std::vector<unsigned char> as_png(const Job& job) {
    return encode_png({.size = job.picture.pixels.size(),
                       .channels = job.channels,
                       .values = bytes_of(job),
                       .texts = attributes_of(job.format, job.metadata)});
}

std::vector<unsigned char> as_jpeg(const Job& job) {
    // The only place for words that needs no Exif block.
    std::string comment;
    for (const auto& [name, value] : attributes_of(job.format, job.metadata)) {
        if (name == lines_attribute) comment = value;
    }
    return encode_jpeg(
        {.size = job.picture.pixels.size(), .values = bytes_of(job), .quality = job.jpeg_quality, .comment = comment});
}

}  // namespace

std::vector<std::string> picture_endings() {
    std::vector<std::string> endings;
    endings.reserve(formats.size());
    for (const Format& format : formats) endings.emplace_back(format.ending);
    return endings;
}

bool holds_layers(const std::filesystem::path& path) {
    return format_of(path).layers;
}

void check_picture_ending(const std::filesystem::path& path) {
    format_of(path);
}

void check_picture_path(const std::filesystem::path& path) {
    check_picture_ending(path);
    check_file_path(path);
}

std::vector<unsigned char> encode_picture(const std::filesystem::path& path, const Picture& picture,
                                          const Metadata& metadata, int jpeg_quality) {
    const Format& format = format_of(path);
    const auto pixels = picture.pixels.pixels();
    const bool opaque = std::ranges::all_of(pixels, [](const Rgba& pixel) { return pixel[3] >= 1; });
    const int channels = opaque || !format.alpha ? 3 : 4;
    return format.encode({format, path, picture, metadata, jpeg_quality, channels});
}

void write_picture(const std::filesystem::path& path, const Picture& picture, const Metadata& metadata) {
    // Encoded in memory: then every byte goes through our own checked write, and no library's opinion of a full disk.
    const std::vector<unsigned char> encoded = encode_picture(path, picture, metadata);
    replace_file(path, std::as_bytes(std::span(encoded)));
}

Picture read_picture(const std::filesystem::path& path) {
    const Samples samples = read_samples(path);
    const std::size_t channels = samples.channels.size();
    const bool grey = channels < 3;
    const auto named = [&](std::string_view name) { return std::ranges::find(samples.channels, name); };
    const auto alpha = named("A");
    const auto index_of = [&](auto at) { return static_cast<std::size_t>(at - samples.channels.begin()); };
    Picture picture{Plane<Rgba>(samples.size), samples.encoding};
    for (std::size_t i = 0; i < picture.pixels.pixels().size(); ++i) {
        const auto from = std::span(samples.values).subspan(i * channels, channels);
        picture.pixels.pixels()[i] = {from[0], from[grey ? 0 : 1], from[grey ? 0 : 2],
                                      alpha == samples.channels.end() ? 1 : from[index_of(alpha)]};
    }
    for (const LayerChannel& channel : layer_channels) {
        const auto at = named(channel.name);
        if (at == samples.channels.end()) continue;
        Plane<float>& plane = picture.layers.*channel.plane;
        plane = Plane<float>(picture.pixels.size());
        for (std::size_t i = 0; i < plane.pixels().size(); ++i) {
            plane.pixels()[i] = samples.values[i * channels + index_of(at)];
        }
    }
    return picture;
}

Metadata read_metadata(const std::filesystem::path& path) {
    Metadata metadata;
    std::istringstream description;
    for (const auto& [name, value] : picture_codec().attributes(path)) {
        if (name.starts_with(setting_prefix)) metadata.emplace_back(name.substr(setting_prefix.size()), value);
        if (name == lines_attribute) description.str(value);
    }
    for (std::string line; std::getline(description, line);) {
        const auto equals = line.find('=');
        if (line.starts_with(setting_prefix) && equals != std::string::npos) {
            metadata.emplace_back(line.substr(setting_prefix.size(), equals - setting_prefix.size()),
                                  line.substr(equals + 1));
        }
    }
    return metadata;
}

}  // namespace vvr
