#include "core/image/png_text.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>

extern "C" {
#include <libavutil/crc.h>
#include <libavutil/intreadwrite.h>
}

namespace vvr::image {

namespace {

using Bytes = std::span<const std::byte>;

constexpr std::size_t signature = 8;
constexpr std::size_t word = 4;  // bytes of a chunk's length, of its name, and of its checksum

const std::uint8_t* raw(Bytes bytes) {
    return reinterpret_cast<const std::uint8_t*>(bytes.data());
}

void append(std::vector<std::byte>& to, Bytes bytes) {
    to.insert(to.end(), bytes.begin(), bytes.end());
}

void append_number(std::vector<std::byte>& to, std::size_t number) {
    for (const int shift : {24, 16, 8, 0}) to.push_back(static_cast<std::byte>(number >> shift));
}

/// \param text keyword, a zero and the text
void append_utf8_chunk(std::vector<std::byte>& to, Bytes text) {
    using namespace std::literals;
    const auto key_end = std::ranges::find(text, std::byte{0});
    std::vector<std::byte> chunk;
    append(chunk, std::as_bytes(std::span("iTXt"sv)));
    append(chunk, {text.begin(), key_end});
    append(chunk, std::as_bytes(std::span("\0\0\0\0\0"sv)));  // not compressed, of no language, keyword not translated
    append(chunk, {key_end + 1, text.end()});
    append_number(to, chunk.size() - word);
    append(to, chunk);
    append_number(to, ~av_crc(av_crc_get_table(AV_CRC_32_IEEE_LE), ~0U, raw(chunk), chunk.size()));
}

}  // namespace

std::vector<std::byte> with_utf8_texts(const std::vector<std::byte>& png) {
    const Bytes whole(png);
    std::vector<std::byte> marked(png.begin(), png.begin() + signature);
    for (Bytes left = whole.subspan(signature); !left.empty();) {
        const std::size_t length = AV_RB32(raw(left));
        const Bytes chunk = left.first(word + word + length + word);
        const Bytes text = chunk.subspan(word + word, length);
        const bool is_text = std::ranges::equal(chunk.subspan(word, word), std::as_bytes(std::span("tEXt", word)));
        if (is_text && std::ranges::any_of(text, [](std::byte byte) { return byte > std::byte{0x7F}; })) {
            append_utf8_chunk(marked, text);
        } else {
            append(marked, chunk);
        }
        left = left.subspan(chunk.size());
    }
    return marked;
}

}  // namespace vvr::image
