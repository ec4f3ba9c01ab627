#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/av_writer.h"
#include "core/video/input.h"
#include "core/video/piece.h"

namespace vvr {

/// One row of the table of containers that clips are written in.
struct ContainerRow {
    std::string_view name;  ///< the file's ending
    const char* muxer;      ///< libav's name
};

std::span<const ContainerRow> containers();

/// The container of a file's ending.
/// \throws Error usage where there is none
const ContainerRow& container_of(const std::filesystem::path& path);

/// What was copied.
struct Copied {
    std::int64_t packets = 0;           ///< of the video
    std::vector<std::string> left_out;  ///< streams that are neither picture, sound nor text, or covers
    bool stopped = false;               ///< before the end, as asked
};

/// Copies a piece of a clip byte for byte, with all its streams, into a container. Times start at 0 with the key frame.
/// The same input and piece give the same bytes.
/// \param rate frames per second of what carries no times
/// \param stopped asked now and then whether to stop
/// \throws Error usage where the container can't hold a stream, which names some that can; io
Copied copy_piece(const Input& input, double rate, const Piece& piece, const std::filesystem::path& path,
                  const WriteAt& write_at, const std::function<bool()>& stopped);

}  // namespace vvr
