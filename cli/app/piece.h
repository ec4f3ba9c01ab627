#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "cli/app/footage.h"
#include "cli/app/observer.h"
#include "core/base/plane.h"
#include "core/base/wall_clock.h"

namespace vvr::app {

/// A piece of footage, completely resolved.
struct PieceJob {
    std::string name;    ///< of the footage, for log lines
    std::string camera;  ///< empty = unknown
    std::vector<FootagePart> parts;
    video::FrameSpan span;  ///< as requested, in seconds of the recording
    WallClock clock{};      ///< of the recording; none = unknown
    std::optional<std::int64_t>
        created{};  ///< without a clock: the container's creation time, seconds since 1970 (UTC)
    InputOptions input;
    int threads = 0;
    bool warns_of_early_end = true;  ///< warn if the footage ends before the piece
    std::filesystem::path path;
    std::filesystem::path place{};  ///< its final path, for log lines; empty = `path`

    const std::filesystem::path& shown() const { return place.empty() ? path : place; }
};

/// The times of a piece that was written: of its first and its last frame, in seconds of the recording.
struct PieceTimes {
    double begin = 0;
    double end = 0;
};

/// The default extension of an exact piece.
std::string_view exact_extension();

/// \throws Error usage when no exact piece can be written to that file type
void check_exact(const std::filesystem::path& path);

/// Copies packets, from the key frame before the piece on.
/// \returns nothing if it was stopped
/// \throws Error usage, io, not_video, limit
std::optional<PieceTimes> copy_piece(const PieceJob& job, Observer& observer, const std::stop_token& stop);

/// Encodes exactly the frames of the piece, without sound.
std::optional<PieceTimes> encode_piece(const PieceJob& job, Observer& observer, const std::stop_token& stop);

/// A frame in full size.
struct FullFrame {
    double seconds = 0;  ///< of the recording
    Plane<Bgr> picture;
};

/// The frame of a piece that is shown at a time, or the next one.
/// \param seconds of the recording
/// \throws Error not_video if no frame decodes from there on
FullFrame frame_of(const PieceJob& job, double seconds);

}  // namespace vvr::app
