#include "core/image/jpeg.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include <turbojpeg.h>

#include <fmt/format.h>

#include "core/base/error.h"

namespace vvr::image {

namespace {

constexpr int quality_in_memory = 85;

struct Destroy {
    void operator()(void* handle) const { tjDestroy(handle); }
};
using Handle = std::unique_ptr<void, Destroy>;

Handle owned(tjhandle made) {
    if (made == nullptr) throw std::bad_alloc();
    return Handle(made);
}

/// Throws what the library says of its last call.
[[noreturn]] void fail(const Handle& handle, std::string_view what) {
    const std::string why = tjGetErrorStr2(handle.get());
    const bool memory = why.find("nsufficient memory") != std::string::npos ||  // libjpeg's
                        why.find("Memory allocation") != std::string::npos;     // TurboJPEG's
    throw Error(memory ? ErrorCode::out_of_memory : ErrorCode::io, fmt::format("cannot {}: {}", what, why));
}

/// A picture for the library: its values are interleaved, top row first.
struct JpegSource {
    const std::byte* values;
    Size size;
    int format;       ///< TJPF
    int subsampling;  ///< TJSAMP
    int quality;      ///< 1..100
};

std::vector<std::byte> encode(const JpegSource& source, std::string_view what) {
    const Handle handle = owned(tjInitCompress());
    std::vector<std::byte> room(tjBufSize(source.size.width, source.size.height, source.subsampling));
    auto* at = reinterpret_cast<unsigned char*>(room.data());
    auto bytes = static_cast<unsigned long>(room.size());  // NOLINT(google-runtime-int): its type
    if (tjCompress2(handle.get(), reinterpret_cast<const unsigned char*>(source.values), source.size.width, 0,
                    source.size.height, source.format, &at, &bytes, source.subsampling, source.quality,
                    TJFLAG_NOREALLOC | TJFLAG_ACCURATEDCT) != 0) {
        fail(handle, what);
    }
    // A copy, because `room` is for the worst case: ten times as large as most pictures, which callers keep.
    return {room.begin(), room.begin() + static_cast<std::ptrdiff_t>(bytes)};
}

void append(std::vector<std::byte>& to, std::string_view text) {
    std::ranges::transform(text, std::back_inserter(to), [](char c) { return static_cast<std::byte>(c); });
}

void append_little(std::vector<std::byte>& to, std::size_t number, int bytes) {
    for (int i = 0; i < bytes; ++i) to.push_back(static_cast<std::byte>(number >> (8 * i) & 0xFF));
}

void append_big16(std::vector<std::byte>& to, std::size_t number) {
    to.push_back(static_cast<std::byte>(number >> 8 & 0xFF));
    to.push_back(static_cast<std::byte>(number & 0xFF));
}

/// The texts as a marker segment of JPEG: an Exif header and a TIFF directory with an entry per text (Exif 2.3, 4.5 and
/// 4.6.4).
std::vector<std::byte> exif_segment(const Metadata& attributes) {
    constexpr std::array<std::pair<std::string_view, int>, 2> tags{
        {{"ImageDescription", 0x010E}, {"Software", 0x0131}}};
    constexpr std::size_t header_bytes = 8;
    constexpr std::size_t entry_bytes = 12;
    constexpr int ascii = 2;
    std::vector<std::pair<int, std::string>> texts;  // in the order of tags, as TIFF demands
    for (const auto& [name, tag] : tags) {
        const auto attribute =
            std::ranges::find(attributes, name, [](const auto& pair) { return std::string_view(pair.first); });
        if (attribute == attributes.end()) continue;
        std::string text = attribute->second;
        text.resize(std::max<std::size_t>(text.size() + 1, 5));  // four bytes or fewer would be in the entry itself
        texts.emplace_back(tag, std::move(text));
    }
    std::vector<std::byte> tiff;
    append(tiff, {"II*\0", 4});
    append_little(tiff, header_bytes, 4);
    append_little(tiff, texts.size(), 2);
    std::size_t value = header_bytes + 2 + texts.size() * entry_bytes + 4;
    for (const auto& [tag, text] : texts) {
        append_little(tiff, static_cast<std::size_t>(tag), 2);
        append_little(tiff, ascii, 2);
        append_little(tiff, text.size(), 4);
        append_little(tiff, value, 4);
        value += text.size();
    }
    append_little(tiff, 0, 4);  // no further directory
    for (const auto& [tag, text] : texts) append(tiff, text);

    constexpr std::string_view identifier("Exif\0\0", 6);
    std::vector<std::byte> segment{std::byte{0xFF}, std::byte{0xE1}};
    append_big16(segment, 2 + identifier.size() + tiff.size());
    append(segment, identifier);
    segment.insert(segment.end(), tiff.begin(), tiff.end());
    return segment;
}

std::vector<std::byte> encode_file(const PictureFile& file) {
    std::vector<std::byte> jpeg = encode({file.values.data(), file.size, TJPF_RGB, TJSAMP_420, file.jpeg_quality},
                                         fmt::format("encode '{}'", file.name));
    constexpr std::ptrdiff_t jfif_end = 20;  // the library begins each file with SOI and a JFIF segment of 18 bytes
    const std::vector<std::byte> exif = exif_segment(file.attributes);
    jpeg.insert(jpeg.begin() + jfif_end, exif.begin(), exif.end());
    return jpeg;
}

}  // namespace

const PictureCodec& jpeg_codec() {
    static constexpr PictureCodec codec{encode_file, [](const std::filesystem::path& path, std::string_view format,
                                                        std::optional<std::span<const std::byte>> bytes) {
                                            return openimageio_codec().open(path, format, bytes);
                                        }};
    return codec;
}

std::vector<std::byte> compress(const Plane<Bgr>& picture) {
    // All of the colour, as crops of large frames have all of it.
    return encode({std::as_bytes(picture.pixels()).data(), picture.size(), TJPF_BGR, TJSAMP_444, quality_in_memory},
                  "compress a picture in memory");
}

Plane<Bgr> decompress(std::span<const std::byte> jpeg) {
    const Handle handle = owned(tjInitDecompress());
    const auto* const from = reinterpret_cast<const unsigned char*>(jpeg.data());
    constexpr std::string_view what = "decompress a picture in memory";
    Size size{};
    int subsampling = 0;
    int colour_space = 0;
    if (tjDecompressHeader3(handle.get(), from, jpeg.size(), &size.width, &size.height, &subsampling, &colour_space) !=
        0) {
        fail(handle, what);
    }
    Plane<Bgr> picture = Plane<Bgr>::for_overwrite(size);
    auto* const to = reinterpret_cast<unsigned char*>(std::as_writable_bytes(picture.pixels()).data());
    if (tjDecompress2(handle.get(), from, jpeg.size(), to, size.width, 0, size.height, TJPF_BGR, 0) != 0) {
        fail(handle, what);
    }
    return picture;
}

}  // namespace vvr::image
