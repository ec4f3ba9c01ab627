#include "core/image/samples.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "core/error.h"
#include "core/image/layer_channels.h"

namespace vvr {

namespace {

Samples read(OIIO::ImageInput& input, const std::filesystem::path& name) {
    const OIIO::ImageSpec& spec = input.spec();
    Samples samples{{spec.width, spec.height}, spec.channelnames, {}, Encoding::srgb};
    if (spec.get_string_attribute("oiio:ColorSpace") == "Linear") samples.encoding = Encoding::linear;
    samples.values.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    if (!input.read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, samples.values.data())) {
        throw Error(ErrorKind::io, fmt::format("cannot read picture '{}': {}", name.string(), input.geterror()));
    }
    return samples;
}

[[noreturn]] void throw_unreadable(const std::filesystem::path& name) {
    throw Error(ErrorKind::io, fmt::format("cannot read picture '{}': {}", name.string(), OIIO::geterror()));
}

}  // namespace

Samples read_samples(const std::filesystem::path& path) {
    const auto input = OIIO::ImageInput::open(path.string());
    if (!input) throw_unreadable(path);
    return read(*input, path);
}

Samples decode_samples(const std::filesystem::path& name, std::span<const unsigned char> bytes) {
    OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
    const auto input = OIIO::ImageInput::open(name.string(), nullptr, &memory);
    if (!input) throw_unreadable(name);
    return read(*input, name);
}

Samples without_layers(Samples samples) {
    const auto is_layer = [](const std::string& channel) {
        return std::ranges::find(layer_channels, channel, &LayerChannel::name) != layer_channels.end();
    };
    if (std::ranges::none_of(samples.channels, is_layer)) return samples;
    std::vector<float> kept;
    for (std::size_t i = 0; i < samples.values.size(); ++i) {
        if (!is_layer(samples.channels[i % samples.channels.size()])) kept.push_back(samples.values[i]);
    }
    samples.values = std::move(kept);
    std::erase_if(samples.channels, is_layer);
    return samples;
}

}  // namespace vvr
