#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/media/demuxer.h"
#include "core/media/frame_source.h"
#include "core/media/input.h"

// Containers: what their headers say about a clip, and which streams they can hold.
namespace vvr::media {

/// Describes the video stream by its container, and by the display size of its first frame.
/// \param shape as SourceOptions::aspect
VideoInfo describe(const Demuxer& demuxer, const std::string& name, const AVFrame& first,
                   const std::optional<Aspect>& shape);

/// Longest plausible duration of a clip, seconds: ten years. A header with more is wrong.
inline constexpr double longest_clip = 10 * 365.25 * 86'400;

/// What a container's header states, without decoding.
struct ClipHeader {
    double length = 0;                      ///< seconds; 0 = unknown
    double implausible_length = 0;          ///< duration in the header if above `longest_clip`, seconds
    std::int64_t frames = 0;                ///< estimate; 0 = unknown
    Size picture;                           ///< stored size
    double rate = 0;                        ///< frames per second; 0 = unknown
    std::optional<std::int64_t> created{};  ///< seconds since 1970 (UTC)
};

ClipHeader header_of(const Demuxer& demuxer);

/// The length of the sound as a share of the video's, both from the video's first frame on. 1 if there is no sound or
/// its length is unknown, and also if the two end within seconds.
double share_of_sound(const Demuxer& demuxer);

/// The orientation in the container: the nearest quarter turn, with or without a flip.
Orientation orientation_of(const AVStream& stream);

/// What to do with a piece that can't be copied, for messages.
inline constexpr std::string_view encode_with_ffmpeg =
    "encode the piece again with FFmpeg: ffmpeg -ss 10 -to 20 -i CLIP piece.mp4";

/// A container format that clips can be written in.
struct ContainerRow {
    std::string_view name;              ///< file extension, with its dot
    const char* muxer;                  ///< libav's name of the muxer
    std::array<AVCodecID, 3> played{};  ///< codecs that browsers play in it; AV_CODEC_ID_NONE = no more
};

std::span<const ContainerRow> containers();

/// The container for a file extension.
/// \throws Error usage for an unknown extension
const ContainerRow& container_of(const std::filesystem::path& path);

/// The streams of a clip that are copied: video, audio and subtitles.
std::vector<const AVStream*> media_of(const AVFormatContext& clip);

/// \throws Error usage if the container can't hold a stream of the clip; the message names containers that can
void check_container(const ContainerRow& container, const AVFormatContext& clip, const std::filesystem::path& path);

/// The extension of a container that can hold the clip's streams: the clip's own, or else the first in the table that
/// fits. Empty if none fits.
std::string_view extension_for(const Input& clip, double rate);

/// The same, but for codecs that browsers know a container that they play, if it can hold the clip's streams.
std::string_view extension_to_play(const Input& clip, double rate);

}  // namespace vvr::media
