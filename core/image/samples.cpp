#include "core/image/samples.h"

#include <algorithm>
#include <utility>

#include "core/image/codec.h"
#include "core/image/layer_channels.h"

namespace vvr {

Samples read_samples(const std::filesystem::path& path) {
    return picture_codec().read(path);
}

Samples decode_samples(const std::filesystem::path& name, std::span<const unsigned char> bytes) {
    return picture_codec().decode(name, bytes);
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
