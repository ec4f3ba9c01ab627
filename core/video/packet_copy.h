#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/av_writer.h"
#include "core/video/input.h"
#include "core/video/piece.h"

namespace vvr::video {

/// Of a file's header: libav's keys, and what they say.
using Tags = std::vector<std::pair<std::string, std::string>>;

/// A piece of one of the files that a copy is joined of.
struct CopyPart {
    Input input;
    PacketRange piece;
    double begin = 0;  ///< second of the recording at which the file's first frame is shown
};

/// What was copied.
struct CopyResult {
    std::int64_t packets = 0;           ///< of the video
    std::vector<std::string> left_out;  ///< streams that are neither picture, sound nor text, or covers
    bool stopped = false;               ///< before the end, as asked
};

/// Copies pieces byte for byte, with all their streams, into a container. Times start at 0 with the first key frame,
/// and a gap between two files stays one. The same input and pieces give the same bytes.
/// \param parts in the order of time; at least one
/// \param rate frames per second of what carries no times
/// \param stopped asked now and then whether to stop
/// \throws Error usage where the container can't hold a stream, which names some that can, or where a file's streams
///         are others than those of the first; io
CopyResult copy_pieces(std::span<const CopyPart> parts, double rate, const std::filesystem::path& path,
                       const Tags& tags, const WriteAt& write_at, const std::function<bool()>& stopped);

/// Decodes the beginning of each part of a copy.
/// \param copy what copy_pieces wrote
/// \param path by which messages name it
/// \throws Error not_video where there are other pictures than in the file that it was copied from, or other packets
void check_copy(const std::filesystem::path& copy, std::span<const CopyPart> parts, const CopyResult& copied,
                double rate, const std::filesystem::path& path);

}  // namespace vvr::video
