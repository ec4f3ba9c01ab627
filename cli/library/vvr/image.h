#pragma once

#include <string>
#include <utility>
#include <vector>

namespace vvr {

/// Names and values; the order is kept.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// A picture in memory, with the settings that made it.
struct Image {
    int width = 0;            ///< pixels
    int height = 0;           ///< pixels
    std::vector<float> rgba;  ///< red, green, blue, alpha per pixel, 0..1, sRGB, premultiplied by alpha; 4·width·height
                              ///< values, rows from the top, no padding
    Settings settings;  ///< recorded in the file by write_image
};

/// Writes a picture with its settings. The file is replaced atomically. It contains no date, so equal images give equal
/// bytes.
/// \param file its extension sets the format: .png or another one of `vvr render -o`
/// \throws Failure usage for an unknown extension, or if the image does not have 4·width·height values; io
[[gnu::visibility("default")]] void write_image(const std::string& file, const Image& image);

}  // namespace vvr
