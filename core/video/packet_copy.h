#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/av_writer.h"
#include "core/video/input.h"
#include "core/video/packet_range.h"

namespace vvr::video {

/// Metadata of a container: libav's keys and their values.
using Tags = std::vector<std::pair<std::string, std::string>>;

/// A packet range of one of the files that are joined.
struct CopyPart {
    Input input;
    PacketRange piece;
    double begin = 0;  ///< time of the file's first frame in the recording, seconds
};

/// What was copied.
struct CopyResult {
    std::int64_t packets = 0;           ///< packets of the video stream
    std::vector<std::string> left_out;  ///< omitted streams: cover pictures, and other than video, audio and subtitles
    bool stopped = false;               ///< on request, before the end
};

/// Copies packet ranges into a container without decoding, with all their streams. Timestamps start at 0 with the first
/// key frame, and gaps between files are kept. The output is deterministic.
/// \param parts in order of time; at least one
/// \param rate frames per second of inputs without timestamps
/// \param stopped polled; true = stop
/// \throws Error usage if the container can't hold a stream, or if the streams of two files differ; io if reading or
///         writing fails
CopyResult copy_pieces(std::span<const CopyPart> parts, double rate, const std::filesystem::path& path,
                       const Tags& tags, const WriteAt& write_at, const std::function<bool()>& stopped);

/// Checks a copy: counts its packets, decodes the beginning of each part, and compares both with the source files.
/// \param copy the file that copy_pieces wrote
/// \param path name of the copy in messages
/// \throws Error not_video if packets or pictures differ from the source files
void check_copy(const std::filesystem::path& copy, std::span<const CopyPart> parts, const CopyResult& copied,
                double rate, const std::filesystem::path& path);

}  // namespace vvr::video
