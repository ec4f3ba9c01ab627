#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/image/picture.h"

namespace vvr {

/// The values of a picture file as they stand in it: any number of channels, pixel by pixel, rows from the top.
struct Samples {
    Size size;
    std::vector<std::string> channels;  ///< "R", "G", "B", "A", or what the file calls them
    std::vector<float> values;          ///< integers of a file as 0..1
    Encoding encoding = Encoding::srgb;

    /// The values of the pixel at column `i`, row `j`.
    std::span<const float> at(int i, int j) const {
        const auto place =
            static_cast<std::size_t>(j) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(i);
        return std::span(values).subspan(place * channels.size(), channels.size());
    }
};

/// Reads any picture file that OpenImageIO knows; of several pictures in a file, the first.
/// \throws Error io
Samples read_samples(const std::filesystem::path& path);

/// The same for the bytes of a file that is not on the disk.
/// \param name gives the format by its ending
/// \throws Error io
Samples decode_samples(const std::filesystem::path& name, std::span<const unsigned char> bytes);

/// The same without the channels of layers: what a person sees of a picture. Layers have no numbers where nothing is
/// seen, and frames and seconds where colours have shares.
Samples without_layers(Samples samples);

}  // namespace vvr
