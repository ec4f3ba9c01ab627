#pragma once

#include <string>
#include <utility>
#include <vector>

namespace vvr {

/// Names and values, in an order.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// A picture in memory, with the settings that made it.
struct Image {
    int width = 0;            ///< pixels
    int height = 0;           ///< pixels
    std::vector<float> rgba;  ///< red, green, blue and alpha per pixel, 0..1, as sRGB; colours are multiplied by alpha.
                              ///< 4·width·height values, rows from the top, no padding
    Settings settings;        ///< what write_image records in the file
};

/// Writes a picture with its settings. The file is replaced as a whole or not touched at all; no date goes into it, so
/// the same image gives the same bytes.
/// \param file its ending says the format: .png and the others of `vvr render -o`
/// \throws Failure usage for an ending that no format has, or an image whose values are not 4·width·height; io
[[gnu::visibility("default")]] void write_image(const std::string& file, const Image& image);

}  // namespace vvr
