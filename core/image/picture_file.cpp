#include "core/image/picture_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>
#include <span>
#include <sstream>

#include <OpenImageIO/color.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "core/error.h"
#include "core/image/atomic_file.h"
#include "core/image/layer_channels.h"
#include "core/image/samples.h"
#include "core/suggest.h"
#include "core/version.h"

namespace vvr {

namespace {

constexpr std::string_view setting_prefix = "vvr:";

/// One kind of picture file.
struct Format {
    std::string_view ending;
    OIIO::TypeDesc::BASETYPE type;
    std::string_view compression;
    bool alpha;     ///< holds transparency
    bool settings;  ///< holds attributes of any name; else the settings become lines of the description
    bool layers;    ///< holds further channels of floats
};

constexpr std::array formats{
    Format{".png", OIIO::TypeDesc::UINT8, "zip:6", true, true, false},
    Format{".exr", OIIO::TypeDesc::HALF, "zip", true, true, true},
    Format{".tif", OIIO::TypeDesc::UINT16, "zip", true, false, false},
    Format{".tiff", OIIO::TypeDesc::UINT16, "zip", true, false, false},
    Format{".jpg", OIIO::TypeDesc::UINT8, "jpeg", false, false, false},
    Format{".jpeg", OIIO::TypeDesc::UINT8, "jpeg", false, false, false},
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

/// The colours' values as the file wants them, without alpha where `channels` is 3.
std::vector<float> file_values(const Picture& picture, const Format& format, int channels) {
    const bool encode = picture.encoding == Encoding::linear && format.type != OIIO::TypeDesc::HALF;
    std::vector<float> values;
    values.reserve(picture.pixels.pixels().size() * static_cast<std::size_t>(channels));
    for (Rgba pixel : picture.pixels.pixels()) {
        if (encode && pixel[3] > 0) {
            for (std::size_t c = 0; c < 3; ++c) pixel[c] = OIIO::linear_to_sRGB(pixel[c] / pixel[3]) * pixel[3];
        }
        values.insert(values.end(), pixel.begin(), pixel.begin() + channels);
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

/// Colours stay in the format's own type; half floats would round times and frame numbers.
void add_layer_channels(OIIO::ImageSpec& spec) {
    spec.channelformats.assign(static_cast<std::size_t>(spec.nchannels), spec.format);
    for (const LayerChannel& channel : layer_channels) {
        spec.channelnames.emplace_back(channel.name);
        spec.channelformats.push_back(OIIO::TypeDesc::FLOAT);
    }
    spec.z_channel = spec.nchannels;
    spec.nchannels += static_cast<int>(layer_channels.size());
}

void add_attributes(OIIO::ImageSpec& spec, const Format& format, const Metadata& metadata) {
    spec.attribute("Software", fmt::format("vvr {}", version()));
    // Without a value of its own OpenImageIO writes the current time: same input, other bytes.
    spec.attribute("DateTime", "");
    std::string lines;
    for (const auto& [name, value] : metadata) {
        const std::string full_name = fmt::format("{}{}", setting_prefix, name);
        if (format.settings) spec.attribute(full_name, value);
        lines += fmt::format("{}={}\n", full_name, value);
    }
    if (!format.settings && !lines.empty()) spec.attribute("ImageDescription", lines);
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
    std::vector<float> values = file_values(picture, format, channels);

    OIIO::ImageSpec spec(picture.pixels.width(), picture.pixels.height(), channels, format.type);
    if (format.layers && !picture.layers.empty()) {
        values = with_layers(values, channels, picture.layers);
        add_layer_channels(spec);
    }
    const bool linear = picture.encoding == Encoding::linear && format.type == OIIO::TypeDesc::HALF;
    const bool jpeg = format.compression == "jpeg";
    spec.attribute("Compression", jpeg ? fmt::format("jpeg:{}", jpeg_quality) : std::string(format.compression));
    // TIFF and JPEG would need an Exif block to say it, and integers in them are taken for sRGB anyway.
    if (format.settings) spec.attribute("oiio:ColorSpace", linear ? "Linear" : "sRGB");
    add_attributes(spec, format, metadata);

    OIIO::Filesystem::IOVecOutput encoded;
    const auto output = OIIO::ImageOutput::create(std::string(format.ending.substr(1)));
    const bool done = output && output->set_ioproxy(&encoded) && output->open(path.string(), spec) &&
                      output->write_image(OIIO::TypeDesc::FLOAT, values.data()) && output->close();
    if (!done) {
        throw Error(ErrorKind::io, fmt::format("cannot encode '{}': {}", path.string(),
                                               output ? output->geterror() : OIIO::geterror()));
    }
    return encoded.buffer();
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
    const auto input = OIIO::ImageInput::open(path.string());
    if (!input) {
        throw Error(ErrorKind::io, fmt::format("cannot read picture '{}': {}", path.string(), OIIO::geterror()));
    }
    Metadata metadata;
    for (const auto& attribute : input->spec().extra_attribs) {
        const std::string name = attribute.name().string();
        if (name.starts_with(setting_prefix)) {
            metadata.emplace_back(name.substr(setting_prefix.size()), attribute.get_string());
        }
    }
    std::istringstream description(input->spec().get_string_attribute("ImageDescription"));
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
