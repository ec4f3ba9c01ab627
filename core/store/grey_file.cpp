#include "core/store/grey_file.h"

#include <algorithm>
#include <utility>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "core/error.h"

namespace vvr {
namespace {

std::vector<unsigned char> encode(Size size, int channels, const std::uint8_t* values) {
    OIIO::ImageSpec spec(size.width, size.height, channels, OIIO::TypeDesc::UINT8);
    // Differences are mostly empty: the fastest level already leaves little of them.
    spec.attribute("Compression", "zip:1");
    // Without a value of its own OpenImageIO writes the current time.
    spec.attribute("DateTime", "");
    OIIO::Filesystem::IOVecOutput encoded;
    const auto output = OIIO::ImageOutput::create("png");
    const bool done = output && output->set_ioproxy(&encoded) && output->open("data.png", spec) &&
                      output->write_image(OIIO::TypeDesc::UINT8, values) && output->close();
    if (!done) {
        throw Error(ErrorKind::io,
                    fmt::format("cannot encode a PNG picture: {}", output ? output->geterror() : OIIO::geterror()));
    }
    return std::move(encoded.buffer());
}

void read(const std::filesystem::path& path, Size size, int channels, std::uint8_t* values) {
    const auto fail = [&path](const std::string& what) {
        throw Error(ErrorKind::io, fmt::format("cannot read '{}': {}; run `vvr extract` again", path.string(), what));
    };
    if (!std::filesystem::exists(path)) fail("there is no such file");
    const auto input = OIIO::ImageInput::open(path.string());
    if (!input) fail(OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    if (Size{spec.width, spec.height} != size || spec.nchannels != channels ||
        spec.format != OIIO::TypeDesc(OIIO::TypeDesc::UINT8)) {
        fail(fmt::format("{}x{} with {} channel(s) of {} where 8-bit {}x{} with {} is due", spec.width, spec.height,
                         spec.nchannels, spec.format.c_str(), size.width, size.height, channels));
    }
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, values)) fail(input->geterror());
}

void swap_red_and_blue(Plane<Bgr>& plane) {
    for (Bgr& pixel : plane.pixels()) std::swap(pixel[0], pixel[2]);
}

}  // namespace

std::vector<unsigned char> encode_grey(const Plane<std::uint8_t>& plane) {
    return encode(plane.size(), 1, plane.pixels().data());
}

std::vector<unsigned char> encode_colour(const Plane<Bgr>& plane) {
    Plane<Bgr> rgb = plane;
    swap_red_and_blue(rgb);
    return encode(plane.size(), 3, rgb.pixels().front().data());
}

Plane<std::uint8_t> read_grey(const std::filesystem::path& path, Size size) {
    Plane<std::uint8_t> plane(size);
    read(path, size, 1, plane.pixels().data());
    return plane;
}

Plane<Bgr> read_colour(const std::filesystem::path& path, Size size) {
    Plane<Bgr> plane(size);
    read(path, size, 3, plane.pixels().front().data());
    swap_red_and_blue(plane);
    return plane;
}

}  // namespace vvr
