// All that is OpenImageIO's. The library that is made of this file alone is loaded by core/image/codec.cpp.
#include <memory>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "core/error.h"
#include "core/image/codec.h"

namespace vvr {
namespace {

OIIO::TypeDesc type_of(Stored stored) {
    switch (stored) {
        case Stored::uint8:
            return OIIO::TypeDesc::UINT8;
        case Stored::uint16:
            return OIIO::TypeDesc::UINT16;
        case Stored::half:
            return OIIO::TypeDesc::HALF;
    }
    return OIIO::TypeDesc::UNKNOWN;
}

/// Colours stay in the format's own type; half floats would round times and frame numbers.
void add_layer_channels(OIIO::ImageSpec& spec, const std::vector<std::string>& names) {
    spec.channelformats.assign(static_cast<std::size_t>(spec.nchannels), spec.format);
    for (const std::string& name : names) {
        spec.channelnames.push_back(name);
        spec.channelformats.push_back(OIIO::TypeDesc::FLOAT);
    }
    spec.z_channel = spec.nchannels;
    spec.nchannels += static_cast<int>(names.size());
}

std::vector<unsigned char> encode(const PictureFile& file) {
    OIIO::ImageSpec spec(file.size.width, file.size.height, file.colours, type_of(file.stored));
    if (!file.layers.empty()) add_layer_channels(spec, file.layers);
    for (const auto& [name, value] : file.attributes) spec.attribute(name, value);
    OIIO::Filesystem::IOVecOutput encoded;
    const auto output = OIIO::ImageOutput::create(file.format);
    const bool done = output && output->set_ioproxy(&encoded) && output->open(file.name, spec) &&
                      output->write_image(OIIO::TypeDesc::FLOAT, file.values.data()) && output->close();
    if (!done) {
        throw Error(ErrorKind::io,
                    fmt::format("cannot encode '{}': {}", file.name, output ? output->geterror() : OIIO::geterror()));
    }
    return std::move(encoded.buffer());
}

[[noreturn]] void throw_unreadable(const std::filesystem::path& name, const std::string& why) {
    throw Error(ErrorKind::io, fmt::format("cannot read picture '{}': {}", name.string(), why));
}

Samples read_from(OIIO::ImageInput& input, const std::filesystem::path& name) {
    const OIIO::ImageSpec& spec = input.spec();
    Samples samples{{spec.width, spec.height}, spec.channelnames, {}, Encoding::srgb};
    if (spec.get_string_attribute("oiio:ColorSpace") == "Linear") samples.encoding = Encoding::linear;
    samples.values.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    if (!input.read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, samples.values.data())) {
        throw_unreadable(name, input.geterror());
    }
    return samples;
}

Samples read(const std::filesystem::path& path) {
    const auto input = OIIO::ImageInput::open(path.string());
    if (!input) throw_unreadable(path, OIIO::geterror());
    return read_from(*input, path);
}

Samples decode(const std::filesystem::path& name, std::span<const unsigned char> bytes) {
    OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
    const auto input = OIIO::ImageInput::open(name.string(), nullptr, &memory);
    if (!input) throw_unreadable(name, OIIO::geterror());
    return read_from(*input, name);
}

Metadata attributes(const std::filesystem::path& path) {
    const auto input = OIIO::ImageInput::open(path.string());
    if (!input) throw_unreadable(path, OIIO::geterror());
    Metadata found;
    for (const auto& attribute : input->spec().extra_attribs) {
        found.emplace_back(attribute.name().string(), attribute.get_string());
    }
    return found;
}

void read_bytes(const std::filesystem::path& path, Size size, int channels, std::uint8_t* values) {
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

}  // namespace
}  // namespace vvr

extern "C" __attribute__((visibility("default"))) const vvr::PictureCodec* vvr_picture_codec() {
    static constexpr vvr::PictureCodec codec{vvr::encode, vvr::read, vvr::decode, vvr::attributes, vvr::read_bytes};
    return &codec;
}
