#include "core/media/frame_choice.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

extern "C" {
#include <libavcodec/avcodec.h>
}

namespace vvr::media {

namespace {

using Bytes = std::span<const std::uint8_t>;

/// How a codec's units (NAL units) begin.
struct UnitFormat {
    AVCodecID codec;
    int smallest_header;  ///< bytes of the stream's header where each unit has its length in front
    int length_at;        ///< in that header: the size of a length minus 1, in two bits
    bool (*refers)(
        std::uint8_t first);  ///< whether a unit with this first byte is a part of a frame that others refer to
};

constexpr std::array formats{
    // Slices have the types 1 to 5; two bits before the type say whether others refer to it.
    UnitFormat{AV_CODEC_ID_H264, 7, 4,
               [](std::uint8_t first) {
                   const int type = first & 0x1F;
                   return type >= 1 && type <= 5 && (first & 0x60) != 0;
               }},
    // Slices have types below 32. Even ones below 16 are of frames that no other frame of their layer refers to.
    UnitFormat{AV_CODEC_ID_HEVC, 23, 21,
               [](std::uint8_t first) {
                   const int type = first >> 1 & 0x3F;
                   return type < 32 && (type >= 16 || type % 2 == 1);
               }},
};

/// The bytes of each length in front of a unit; 0 = units are separated by the bytes 0 0 1.
std::size_t length_bytes(const UnitFormat& format, const AVCodecParameters& stream) {
    if (stream.extradata_size < format.smallest_header || stream.extradata[0] != 1) return 0;
    return (stream.extradata[format.length_at] & 3U) + 1;
}

/// Whether any unit does, of those that have their length in front.
bool any_refers(Bytes bytes, std::size_t length, const UnitFormat& format) {
    while (bytes.size() > length) {
        std::size_t unit = 0;
        for (const std::uint8_t byte : bytes.first(length)) unit = unit << 8U | byte;
        bytes = bytes.subspan(length);
        if (format.refers(bytes.front())) return true;
        bytes = bytes.subspan(std::min(unit, bytes.size()));
    }
    return false;
}

/// Whether any unit does, of those that 0 0 1 separates.
bool any_refers(Bytes bytes, const UnitFormat& format) {
    for (std::size_t i = 3; i < bytes.size(); ++i) {
        const bool begins = bytes[i - 1] == 1 && bytes[i - 2] == 0 && bytes[i - 3] == 0;
        if (begins && format.refers(bytes[i])) return true;
    }
    return false;
}

bool any_frame(const AVPacket&, const AVCodecParameters&) {
    return true;
}

bool is_key(const AVPacket& packet, const AVCodecParameters&) {
    return (packet.flags & AV_PKT_FLAG_KEY) != 0;
}

constexpr std::array frame_choice_rows{
    FrameChoiceRow{"all", "every frame", any_frame},
    FrameChoiceRow{"reference", "in H.264 and H.265, only frames that others refer to", is_referenced},
    FrameChoiceRow{"key", "only key frames, for a first look: the objects of short visits are missing", is_key, true},
    FrameChoiceRow{"auto",
                   "'reference' if at least two frames share a layer and fields are at most half as wide as the video; "
                   "else 'all'",
                   any_frame, false, true},
};

}  // namespace

std::span<const FrameChoiceRow> frame_choices() {
    return frame_choice_rows;
}

const FrameChoiceRow& row_of(Name<FrameChoiceRow> name) {
    return choose("decode", name.text, frame_choices());
}

bool is_referenced(const AVPacket& packet, const AVCodecParameters& stream) {
    for (const UnitFormat& format : formats) {
        if (format.codec != stream.codec_id) continue;
        const Bytes bytes(packet.data, static_cast<std::size_t>(packet.size));
        const std::size_t length = length_bytes(format, stream);
        return length > 0 ? any_refers(bytes, length, format) : any_refers(bytes, format);
    }
    return true;
}

}  // namespace vvr::media
