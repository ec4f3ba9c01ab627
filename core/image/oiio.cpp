// All uses of OpenImageIO. This file is a library of its own, which core/image/picture_file.cpp loads.
#include <memory>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/error.h"
#include "core/image/picture_file.h"

namespace vvr::image {
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

/// Adds float channels. Colours keep the format's type, but half floats would round times and frame numbers.
void add_pixel_data_channels(OIIO::ImageSpec& spec, const std::vector<std::string>& names) {
    spec.channelformats.assign(static_cast<std::size_t>(spec.nchannels), spec.format);
    for (const std::string& name : names) {
        spec.channelnames.push_back(name);
        spec.channelformats.push_back(OIIO::TypeDesc::FLOAT);
    }
    spec.z_channel = spec.nchannels;
    spec.nchannels += static_cast<int>(names.size());
}

std::vector<std::byte> encode(const PictureFile& file) {
    OIIO::ImageSpec spec(file.size.width, file.size.height, file.colours, type_of(file.stored));
    if (!file.pixel_data.empty()) add_pixel_data_channels(spec, file.pixel_data);
    for (const auto& [name, value] : file.attributes) spec.attribute(name, value);
    for (const auto& [name, value] : file.options) spec.attribute(name, value);
    // Otherwise OpenImageIO writes the current time, and the output would not be deterministic.
    spec.attribute("DateTime", "");
    const bool bytes = file.stored == Stored::uint8;
    if (bytes) spec.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::Filesystem::IOVecOutput encoded;
    const auto output = OIIO::ImageOutput::create(file.format);
    const bool done = output && output->set_ioproxy(&encoded) && output->open(file.name, spec) &&
                      output->write_image(bytes ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT, file.values.data()) &&
                      output->close();
    if (!done) {
        const std::string why = output ? output->geterror() : OIIO::geterror();
        // It writes to memory, so without a message it is a lack of threads, which OpenEXR doesn't report.
        if (why.empty()) {
            throw Error(
                ErrorCode::out_of_memory,
                fmt::format("cannot encode '{}': out of memory or threads; choose a smaller picture", file.name),
                {"size"});
        }
        throw Error(ErrorCode::io, fmt::format("cannot encode '{}': {}; choose another format", file.name, why));
    }
    const auto whole = std::as_bytes(std::span(encoded.buffer()));
    return {whole.begin(), whole.end()};
}

[[noreturn]] void throw_unreadable(const std::filesystem::path& name, const std::string& why) {
    throw Error(ErrorCode::file_invalid,
                fmt::format("cannot read picture '{}': {}; check that the file is complete", name.string(), why));
}

// Limit for the values of a picture over all channels: 2 GB. A small file may claim more.
constexpr std::uint64_t most_values = 500'000'000;

/// Opens a picture with the reader of its format only. OpenImageIO would otherwise try dozens of readers, and some of
/// them crash on unexpected files.
/// \param memory the file's bytes; null = read `path`
std::unique_ptr<OIIO::ImageInput> open(const std::filesystem::path& path, std::string_view format,
                                       OIIO::Filesystem::IOMemReader* memory) {
    auto input = OIIO::ImageInput::create(std::string(format));
    if (!input) throw_unreadable(path, OIIO::geterror());
    if (memory != nullptr) input->set_ioproxy(memory);
    OIIO::ImageSpec spec;
    OIIO::ImageSpec as_stored;
    as_stored.attribute("oiio:UnassociatedAlpha", 1);
    if (!input->open(path.string(), spec, as_stored)) throw_unreadable(path, input->geterror());
    const bool flat = spec.width > 0 && spec.height > 0 && spec.depth == 1 && spec.nchannels > 0 && !spec.deep;
    if (!flat || static_cast<std::uint64_t>(spec.nchannels) > most_values / spec.image_pixels()) {
        throw Error(
            ErrorCode::picture_too_large,
            fmt::format("cannot read picture '{}': {}x{} pixels with {} channel(s) exceed the limit of {} million "
                        "values; choose a smaller picture",
                        path.string(), spec.width, spec.height, spec.nchannels, most_values / 1'000'000));
    }
    return input;
}

/// Multiplies colours by alpha where the file stores them without it. OpenImageIO 2.5 would multiply other values than
/// 2.4 does, so that a picture would not be read as it was written.
void associate_alpha(const OIIO::ImageSpec& spec, std::vector<float>& values) {
    if (spec.alpha_channel < 0 || spec.get_int_attribute("oiio:UnassociatedAlpha") == 0) return;
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    const auto alpha = static_cast<std::size_t>(spec.alpha_channel);
    for (std::size_t pixel = 0; pixel < values.size(); pixel += channels) {
        for (std::size_t channel = 0; channel < channels; ++channel) {
            if (channel != alpha) values[pixel + channel] *= values[pixel + alpha];
        }
    }
}

Samples read(const std::filesystem::path& path, std::string_view format,
             std::optional<std::span<const std::byte>> bytes) {
    std::optional<OIIO::Filesystem::IOMemReader> memory;
    if (bytes) memory.emplace(bytes->data(), bytes->size());
    const auto input = open(path, format, memory ? &*memory : nullptr);
    const OIIO::ImageSpec& spec = input->spec();
    Samples samples{{spec.width, spec.height}, spec.channelnames, {}, {}};
    for (const auto& attribute : spec.extra_attribs) {
        samples.attributes.emplace_back(attribute.name().string(), attribute.get_string());
    }
    samples.values.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, samples.values.data())) {
        throw_unreadable(path, input->geterror());
    }
    associate_alpha(spec, samples.values);
    return samples;
}

void read_grey(const std::filesystem::path& path, std::string_view format, Size size, float* values) {
    const auto input = open(path, format, nullptr);
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.nchannels != 1) {
        throw Error(ErrorCode::file_invalid,
                    fmt::format("'{}' has {} channels ({}), not one; write it as a grey picture without alpha",
                                path.string(), spec.nchannels, fmt::join(spec.channelnames, ", ")));
    }
    if (Size{spec.width, spec.height} != size) {
        throw Error(
            ErrorCode::file_invalid,
            fmt::format("'{}' has {}x{} pixels, but the clip's fields have {}x{}; give field-size {}x{}, or "
                        "scale the pictures",
                        path.string(), spec.width, spec.height, size.width, size.height, spec.width, spec.height),
            {"field-size"});
    }
    if (!input->read_image(0, 0, 0, 1, OIIO::TypeDesc::FLOAT, values)) throw_unreadable(path, input->geterror());
}

void read_bytes(const std::filesystem::path& path, Size size, int channels, std::uint8_t* values) {
    const auto fail = [&path](const std::string& what, ErrorCode code = ErrorCode::file_invalid) {
        throw Error(code, fmt::format("cannot read '{}': {}; run `vvr extract` again", path.string(), what));
    };
    if (!std::filesystem::exists(path)) fail("the file does not exist", ErrorCode::file_not_found);
    const auto input = OIIO::ImageInput::create("png");
    if (!input) fail(OIIO::geterror());
    OIIO::ImageSpec spec;
    if (!input->open(path.string(), spec)) fail(input->geterror());
    if (Size{spec.width, spec.height} != size || spec.nchannels != channels ||
        spec.format != OIIO::TypeDesc(OIIO::TypeDesc::UINT8)) {
        fail(fmt::format("it has {}x{} pixels with {} channel(s) of {}, not {}x{} pixels with {} channel(s) of uint8",
                         spec.width, spec.height, spec.nchannels, spec.format.c_str(), size.width, size.height,
                         channels));
    }
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, values)) fail(input->geterror());
}

}  // namespace
}  // namespace vvr::image

extern "C" __attribute__((visibility("default"))) const vvr::image::PictureCodec* vvr_picture_codec() {
    static constexpr vvr::image::PictureCodec codec{vvr::image::encode, vvr::image::read, vvr::image::read_grey,
                                                    vvr::image::read_bytes};
    return &codec;
}
