#include "core/image/samples.h"

#include <algorithm>
#include <utility>

#include "core/image/codec.h"
#include "core/image/pixel_data_channels.h"
#include "core/read_file.h"

namespace vvr {

Samples read_samples(const std::filesystem::path& path) {
    check_is_file(path.string());
    return picture_codec().read(path, std::nullopt);
}

Samples decode_samples(const std::filesystem::path& name, std::span<const std::byte> bytes) {
    return picture_codec().read(name, bytes);
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

}  // namespace vvr
