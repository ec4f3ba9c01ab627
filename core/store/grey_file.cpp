#include "core/store/grey_file.h"

#include <cstdint>
#include <span>
#include <utility>

#include "core/image/codec.h"
#include "core/image/png_encoder.h"

namespace vvr {
namespace {

std::vector<unsigned char> encode(Size size, int channels, std::span<const std::uint8_t> values) {
    // Differences are mostly empty: the fastest level already leaves little of them.
    return encode_png({.size = size, .channels = channels, .values = values, .level = 1, .filter = PngFilter::none});
}

void swap_red_and_blue(Plane<Bgr>& plane) {
    for (Bgr& pixel : plane.pixels()) std::swap(pixel[0], pixel[2]);
}

}  // namespace

std::vector<unsigned char> encode_grey(const Plane<std::uint8_t>& plane) {
    return encode(plane.size(), 1, plane.pixels());
}

std::vector<unsigned char> encode_colour(const Plane<Bgr>& plane) {
    Plane<Bgr> rgb = plane;
    swap_red_and_blue(rgb);
    return encode(plane.size(), 3, {rgb.pixels().front().data(), 3 * rgb.pixels().size()});
}

Plane<std::uint8_t> read_grey(const std::filesystem::path& path, Size size) {
    auto plane = Plane<std::uint8_t>::for_overwrite(size);
    picture_codec().read_bytes(path, size, 1, plane.pixels().data());
    return plane;
}

Plane<Bgr> read_colour(const std::filesystem::path& path, Size size) {
    auto plane = Plane<Bgr>::for_overwrite(size);
    picture_codec().read_bytes(path, size, 3, plane.pixels().front().data());
    swap_red_and_blue(plane);
    return plane;
}

}  // namespace vvr
