#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "cli/app/footage.h"
#include "cli/app/observer.h"
#include "core/base/wall_clock.h"

namespace vvr::app {

/// A piece of footage, all of which is known.
struct PieceJob {
    std::string name;    ///< of the footage, for messages
    std::string camera;  ///< empty = not known
    std::vector<FootagePart> parts;
    video::FrameSpan span;                  ///< that was asked for, in seconds of the recording
    WallClock clock{};                      ///< of the recording; none = not known
    std::optional<std::int64_t> created{};  ///< then: when its container says it was made, seconds since 1970 (UTC)
    InputOptions input;
    int threads = 0;
    bool tells_early_end = true;  ///< warns where the footage ends before the piece was to
    std::filesystem::path path;
};

/// The ending that an exact piece has if nobody says which.
std::string_view exact_extension();

/// \throws Error usage where no exact piece can be written under that name
void check_exact(const std::filesystem::path& path);

/// Copies packets, from the key frame before the piece on.
/// \returns false where it was stopped
/// \throws Error usage, io, not_video, limit
bool copy_piece(const PieceJob& job, Observer& observer, const std::stop_token& stop);

/// Encodes the frames of the piece anew, without sound.
bool encode_piece(const PieceJob& job, Observer& observer, const std::stop_token& stop);

}  // namespace vvr::app
