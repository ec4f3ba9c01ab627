#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "core/base/setting.h"

struct AVPacket;
struct AVCodecParameters;

namespace vvr::media {

/// Which frames of a video are decoded.
struct FrameChoiceRow {
    std::string_view name;
    std::string_view help;
    bool (*decodes)(const AVPacket& packet, const AVCodecParameters& stream);
    bool alone = false;      ///< each frame decodes without another
    bool automatic = false;  ///< all frames, or those of `reference`
};

/// "all", "reference", "key", "auto".
std::span<const FrameChoiceRow> frame_choices();

const FrameChoiceRow& row_of(Name<FrameChoiceRow> name);

/// Whether other frames may refer to the frame of a packet. True for codecs other than H.264 and H.265.
bool is_referenced(const AVPacket& packet, const AVCodecParameters& stream);

}  // namespace vvr::media
