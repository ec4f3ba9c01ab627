// All uses of OpenImageIO. This file is a library of its own, which core/image/picture_codec.cpp loads.
#include <memory>
#include <optional>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "core/base/error.h"
#include "core/image/picture_codec.h"

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
    if (file.srgb) spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("CompressionQuality", file.jpeg_quality);
    spec.attribute("png:compressionLevel", file.png_level);
    spec.attribute("png:filter", file.png_filter);
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

/// Opens pictures with the reader of their format only. OpenImageIO would otherwise try dozens of readers, and some of
/// them crash on unexpected files.
class Reader : public PictureReader {
  public:
    Reader(const std::filesystem::path& path, std::string_view format, std::optional<std::span<const std::byte>> bytes)
        : path_(path) {
        input_ = OIIO::ImageInput::create(std::string(format));
        if (!input_) throw_unreadable(path, OIIO::geterror());
        if (bytes) input_->set_ioproxy(&memory_.emplace(bytes->data(), bytes->size()));
        OIIO::ImageSpec spec;
        OIIO::ImageSpec as_stored;
        as_stored.attribute("oiio:UnassociatedAlpha", 1);
        if (!input_->open(path.string(), spec, as_stored)) throw_unreadable(path, input_->geterror());
        if (spec.depth == 1 && !spec.deep) size = {spec.width, spec.height};
        channels = spec.channelnames;
        // OpenImageIO 2.5 would multiply other values by alpha than 2.4 does, so that a picture would not be read as it
        // was written.
        if (spec.alpha_channel >= 0 && spec.get_int_attribute("oiio:UnassociatedAlpha") != 0) {
            straight_alpha = static_cast<std::size_t>(spec.alpha_channel);
        }
    }

    Metadata attributes() override {
        Metadata texts;
        for (const auto& attribute : input_->spec().extra_attribs) {
            texts.emplace_back(attribute.name().string(), attribute.get_string());
        }
        return texts;
    }

    void read(float* values) override {
        if (!input_->read_image(0, 0, 0, static_cast<int>(channels.size()), OIIO::TypeDesc::FLOAT, values)) {
            throw_unreadable(path_, input_->geterror());
        }
    }

  private:
    std::filesystem::path path_;
    std::optional<OIIO::Filesystem::IOMemReader> memory_;
    std::unique_ptr<OIIO::ImageInput> input_;
};

std::unique_ptr<PictureReader> open(const std::filesystem::path& path, std::string_view format,
                                    std::optional<std::span<const std::byte>> bytes) {
    return std::make_unique<Reader>(path, format, bytes);
}

}  // namespace
}  // namespace vvr::image

extern "C" __attribute__((visibility("default"))) const vvr::image::PictureCodec* vvr_picture_codec() {
    static constexpr vvr::image::PictureCodec codec{vvr::image::encode, vvr::image::open};
    return &codec;
}
