#include <algorithm>
#include <cstddef>
#include <cstring>

#include <vvr/image.h>

#include <fmt/format.h>

#include "cli/library/as_failure.h"
#include "cli/library/image_of.h"
#include "core/image/picture_file.h"

namespace vvr {

static_assert(sizeof(image::Rgba) == 4 * sizeof(float), "a pixel is four floats, as an Image has them");

Image image_of(const image::Picture& picture, const image::Metadata& settings) {
    const auto values = std::as_bytes(picture.pixels.pixels());
    Image image{picture.pixels.width(), picture.pixels.height(), std::vector<float>(values.size() / sizeof(float)),
                settings};
    std::memcpy(image.rgba.data(), values.data(), values.size());
    return image;
}

void write_image(const std::string& file, const Image& image) {
    as_failure([&] {
        const bool sized = image.width > 0 && image.height > 0;
        const std::size_t values =
            sized ? std::size_t{4} * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) : 0;
        if (!sized || image.rgba.size() != values) {
            throw Error(ErrorCode::usage,
                        fmt::format("'{}': an image of {}x{} pixels can't have {} values; it needs 4 per pixel", file,
                                    image.width, image.height, image.rgba.size()));
        }
        auto pixels = Plane<image::Rgba>::for_overwrite({image.width, image.height});
        std::memcpy(std::as_writable_bytes(pixels.pixels()).data(), image.rgba.data(), values * sizeof(float));
        image::write_picture(file, {std::move(pixels)}, image.settings);
    });
}

}  // namespace vvr
