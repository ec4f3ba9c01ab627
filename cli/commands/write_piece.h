#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "cli/app/observer.h"
#include "cli/commands/footage.h"
#include "core/base/wall_clock.h"

namespace vvr::commands {

/// A piece of footage, completely resolved.
struct PieceJob {
    std::string name;    ///< of the footage, for log lines
    std::string camera;  ///< empty = unknown
    std::vector<FootagePart> parts;
    video::FrameSpan span;  ///< as requested, in seconds of the recording
    WallClock clock{};      ///< of the recording; none = unknown
    std::optional<std::int64_t>
        created{};  ///< without a clock: the container's creation time, seconds since 1970 (UTC)
    app::InputOptions input;
    int threads = 0;
    bool warns_of_early_end = true;  ///< warn if the footage ends before the piece
    std::filesystem::path path;
};

/// The default extension of an exact piece.
std::string_view exact_extension();

/// \throws Error usage when no exact piece can be written to that file type
void check_exact(const std::filesystem::path& path);

/// Copies packets, from the key frame before the piece on.
/// \returns false if it was stopped
/// \throws Error usage, io, not_video, limit
bool copy_piece(const PieceJob& job, app::Observer& observer, const std::stop_token& stop);

/// Encodes exactly the frames of the piece, without sound.
bool encode_piece(const PieceJob& job, app::Observer& observer, const std::stop_token& stop);

}  // namespace vvr::commands
