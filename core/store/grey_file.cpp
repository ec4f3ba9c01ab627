#include "core/store/grey_file.h"

#include <cstdint>
#include <span>
#include <utility>

#include "core/base/read_file.h"
#include "core/image/codec.h"

namespace vvr::store {
namespace {

std::vector<std::byte> encode(Size size, int channels, std::span<const std::uint8_t> values) {
    // Differences are mostly empty: the fastest level without a filter already leaves little of them.
    return image::picture_codec().encode(
        {.format = "png",
         .name = "a plane.png",
         .size = size,
         .colours = channels,
         .options = {{"png:compressionLevel", 1}, {"png:filter", image::png_filter::none}},
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

Plane<std::uint8_t> read_grey(const std::filesystem::path& path, Size size) {
    check_is_file(path.string(), most_bytes::data);
    auto plane = Plane<std::uint8_t>::for_overwrite(size);
    image::picture_codec().read_bytes(path, size, 1, plane.pixels().data());
    return plane;
}

Plane<Bgr> read_colour(const std::filesystem::path& path, Size size) {
    check_is_file(path.string(), most_bytes::data);
    auto plane = Plane<Bgr>::for_overwrite(size);
    image::picture_codec().read_bytes(path, size, 3, plane.pixels().front().data());
    swap_red_and_blue(plane);
    return plane;
}

}  // namespace vvr::store
