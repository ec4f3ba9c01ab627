#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/image/picture.h"
#include "core/image/picture_codec.h"
#include "core/image/picture_file.h"
#include "core/image/png.h"

namespace vvr::image {

namespace {

/// A picture format that can be read.
struct ReadFormat {
    std::string_view name;         ///< OpenImageIO's name
    std::string_view first_bytes;  ///< signature of its files
    const PictureCodec& (*codec)();
};

using namespace std::string_view_literals;
constexpr std::array read_formats{
    ReadFormat{"png", "\x89PNG\r\n\x1a\n"sv, png_codec}, ReadFormat{"jpeg", "\xff\xd8\xff"sv, openimageio_codec},
    ReadFormat{"tiff", "II*\0"sv, openimageio_codec}, ReadFormat{"tiff", "MM\0*"sv, openimageio_codec},
    ReadFormat{"openexr", "\x76\x2f\x31\x01"sv, openimageio_codec}};

constexpr std::size_t longest_begin = 8;

/// \param begin first bytes of the file
const ReadFormat& format_of(const std::filesystem::path& name, std::string_view begin) {
    const auto format =
        std::ranges::find_if(read_formats, [&](const ReadFormat& row) { return begin.starts_with(row.first_bytes); });
    if (format != read_formats.end()) return *format;
    throw Error(ErrorCode::file_invalid,
                fmt::format("cannot read picture '{}': {}", name.string(),
                            begin.empty() ? "the file is empty; give another file"
                                          : "the content is not PNG, JPEG, TIFF or OpenEXR; convert the file"));
}

/// The format of a file, by its first bytes.
const ReadFormat& format_of_file(const std::filesystem::path& path) {
    check_is_file(path.string(), most_bytes::data);
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::array<char, longest_begin> begin{};
    file.read(begin.data(), begin.size());
    if (!file.is_open() || file.bad()) {
        throw system_error(errno, fmt::format("cannot read picture '{}'", path.string()),
                           "check its name and permissions");
    }
    const std::string_view bytes(begin.data(), static_cast<std::size_t>(file.gcount()));
    return format_of(path, bytes);
}

// Limit for the values of a picture over all channels: 2 GB. A small file may claim more.
constexpr std::uint64_t most_values = 500'000'000;

std::unique_ptr<PictureReader> open(const std::filesystem::path& path, const ReadFormat& format,
                                    std::optional<std::span<const std::byte>> bytes = {}) {
    auto reader = format.codec().open(path, format.name, bytes);
    const std::uint64_t pixels =
        static_cast<std::uint64_t>(reader->size.width) * static_cast<std::uint64_t>(reader->size.height);
    if (pixels == 0 || reader->channels.empty() || reader->channels.size() > most_values / pixels) {
        throw Error(
            ErrorCode::picture_too_large,
            fmt::format("cannot read picture '{}': {}x{} pixels with {} channel(s) exceed the limit of {} million "
                        "values; choose a smaller picture",
                        path.string(), reader->size.width, reader->size.height, reader->channels.size(),
                        most_values / 1'000'000));
    }
    return reader;
}

/// Multiplies colours by alpha.
void associate_alpha(std::span<float> values, std::size_t channels, std::size_t alpha) {
    for (std::size_t pixel = 0; pixel < values.size(); pixel += channels) {
        for (std::size_t channel = 0; channel < channels; ++channel) {
            if (channel != alpha) values[pixel + channel] *= values[pixel + alpha];
        }
    }
}

Samples read(PictureReader& reader) {
    Samples samples{reader.size, reader.channels, {}, reader.attributes()};
    samples.values.resize(static_cast<std::size_t>(reader.size.width) * static_cast<std::size_t>(reader.size.height) *
                          reader.channels.size());
    reader.read(samples.values.data());
    if (reader.straight_alpha) associate_alpha(samples.values, reader.channels.size(), *reader.straight_alpha);
    return samples;
}

}  // namespace

Samples read_samples(const std::filesystem::path& path) {
    return read(*open(path, format_of_file(path)));
}

Plane<float> read_grey_samples(const std::filesystem::path& path, Size size) {
    const auto reader = open(path, format_of_file(path));
    if (reader->channels.size() != 1) {
        throw Error(ErrorCode::file_invalid,
                    fmt::format("'{}' has {} channels ({}), not one; write it as a grey picture without alpha",
                                path.string(), reader->channels.size(), fmt::join(reader->channels, ", ")));
    }
    if (reader->size != size) {
        throw Error(ErrorCode::file_invalid,
                    fmt::format("'{}' has {}x{} pixels, but the clip's fields have {}x{}; give field-size {}x{}, or "
                                "scale the pictures",
                                path.string(), reader->size.width, reader->size.height, size.width, size.height,
                                reader->size.width, reader->size.height),
                    {"field-size"});
    }
    auto plane = Plane<float>::for_overwrite(size);
    reader->read(plane.pixels().data());
    return plane;
}

Samples decode_samples(const std::filesystem::path& name, std::span<const std::byte> bytes) {
    const std::string_view begin(reinterpret_cast<const char*>(bytes.data()), std::min(longest_begin, bytes.size()));
    return read(*open(name, format_of(name, begin), bytes));
}

Samples without_pixel_data(Samples samples) {
    const auto is_pixel_data = [](const std::string& channel) {
        return std::ranges::find(pixel_data_channels, channel, &PixelDataChannel::name) != pixel_data_channels.end();
    };
    if (std::ranges::none_of(samples.channels, is_pixel_data)) return samples;
    std::vector<float> kept;
    for (std::size_t i = 0; i < samples.values.size(); ++i) {
        if (!is_pixel_data(samples.channels[i % samples.channels.size()])) kept.push_back(samples.values[i]);
    }
    samples.values = std::move(kept);
    std::erase_if(samples.channels, is_pixel_data);
    return samples;
}

}  // namespace vvr::image
