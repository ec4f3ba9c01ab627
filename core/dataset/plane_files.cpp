#include "core/dataset/plane_files.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/image/picture_codec.h"
#include "core/image/picture_file.h"
#include "core/image/png.h"

namespace vvr::dataset {

namespace fs = std::filesystem;

namespace {

std::vector<std::byte> encode(Size size, int channels, std::span<const std::uint8_t> values) {
    // Differences are mostly empty, so the fastest level without a filter compresses them well enough.
    return image::png_codec().encode({.format = "png",
                                      .name = "a plane.png",
                                      .size = size,
                                      .colours = channels,
                                      .png_level = 1,
                                      .png_filter = image::png_filter::none,
                                      .values = std::as_bytes(values)});
}

void swap_red_and_blue(Plane<Bgr>& plane) {
    for (Bgr& pixel : plane.pixels()) std::swap(pixel[0], pixel[2]);
}

}  // namespace

std::vector<std::byte> encode_grey(const Plane<std::uint8_t>& plane) {
    return encode(plane.size(), 1, plane.pixels());
}

std::vector<std::byte> encode_colour(const Plane<Bgr>& plane) {
    Plane<Bgr> rgb = plane;
    swap_red_and_blue(rgb);
    return encode(plane.size(), 3, {rgb.pixels().front().data(), 3 * rgb.pixels().size()});
}

Plane<std::uint8_t> read_grey(const fs::path& path, Size size) {
    check_is_file(path.string(), most_bytes::data);
    auto plane = Plane<std::uint8_t>::for_overwrite(size);
    image::read_png_bytes(path, 1, plane.size(), plane.pixels());
    return plane;
}

Plane<Bgr> read_colour(const fs::path& path, Size size) {
    check_is_file(path.string(), most_bytes::data);
    auto plane = Plane<Bgr>::for_overwrite(size);
    image::read_png_bytes(path, 3, plane.size(), {plane.pixels().front().data(), 3 * plane.pixels().size()});
    swap_red_and_blue(plane);
    return plane;
}

Plane<std::uint8_t> read_scalar(const std::filesystem::path& file, Size size) {
    const Plane<float> values = image::read_grey_samples(file, size);
    // Written this way, the condition also finds NaN.
    const auto wrong = std::ranges::find_if(values.pixels(), [](float v) { return !(v >= 0 && v <= 1); });
    if (wrong != values.pixels().end()) {
        const auto place = wrong - values.pixels().begin();
        throw Error(
            ErrorCode::file_invalid,
            fmt::format("'{}': the pixel at column {}, row {} is {}, but a scalar field has values from 0 to 1; "
                        "scale the values before they are written",
                        file.string(), place % size.width, place / size.width, *wrong));
    }
    auto scalar = Plane<std::uint8_t>::for_overwrite(size);
    std::ranges::transform(values.pixels(), scalar.pixels().begin(),
                           [](float v) { return static_cast<std::uint8_t>(std::lround(255 * v)); });
    return scalar;
}

}  // namespace vvr::dataset
