#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "cli/excerpt/footage.h"
#include "cli/plan/observer.h"
#include "core/base/plane.h"
#include "core/base/wall_clock.h"
#include "core/footage/unseen.h"
#include "core/image/picture.h"
#include "core/media/frame_gaps.h"

namespace vvr::app {

/// A piece of footage, completely resolved.
struct PieceJob {
    std::string name;    ///< of the footage, for log lines
    std::string camera;  ///< empty = unknown
    std::vector<ExcerptFile> parts;
    std::vector<media::SegmentPlace> places;  ///< of all files that are known
    media::FrameSpan span;                    ///< as requested, in seconds of the recording
    WallClock clock{};                        ///< of the recording; none = unknown
    bool by_clock = false;                    ///< messages tell times of day
    std::optional<std::int64_t>
        created{};  ///< without a clock: the container's creation time, seconds since 1970 (UTC)
    InputOptions input;
    int threads = 0;
    bool warns_of_early_end = true;  ///< warn if the footage ends before the piece
    std::filesystem::path path;
    std::filesystem::path place{};  ///< its final path, for log lines; empty = `path`

    const std::filesystem::path& shown() const { return place.empty() ? path : place; }
};

/// What was written of a piece, by its packets. Times are seconds of the recording.
struct PieceFacts {
    double begin = 0;  ///< of the first frame
    double end = 0;    ///< of the last frame
    double until = 0;  ///< when the last frame is over

    /// What is of one file; numbers of frames are those of the file.
    struct Part {
        std::string file;
        std::int64_t first_frame = 0;
        std::int64_t last_frame = 0;
        std::int64_t frames = 0;  ///< that are there
    };
    std::vector<Part> parts{};
    std::vector<media::FrameGap> gaps{};
    std::vector<media::Damage> damage{};  ///< as the container marks it
};

/// A time for messages, by the clock or in seconds of the recording: "2026-11-22T02:12:10+01:00", "12.500 s".
std::string asked_text(const PieceJob& job, double seconds);

/// An interval for messages, by the clock or in seconds of its files: "148.400 s to 166.200 s of 'a.mp4'", "14.000 s of
/// 'a.mp4' to 3.200 s of 'b.mp4'".
std::string interval_text(const PieceJob& job, double begin, double end);

/// Reports that the footage has no frame in the span of the piece.
/// \param rest what it has instead: "; it ends at 5.000 s", or empty
[[noreturn]] void throw_empty(const PieceJob& job, const std::string& rest);

/// Copies packets, from the key frame before the piece on.
/// \returns nothing if it was stopped
/// \throws Error usage, io, not_video, limit
std::optional<PieceFacts> copy_piece(const PieceJob& job, Observer& observer, const std::stop_token& stop);

/// A frame in full size.
struct FullFrame {
    double seconds = 0;      ///< of the recording
    std::int64_t frame = 0;  ///< number in its file
    Plane<Bgr> picture;
};

/// The frame of the footage that is shown at a time, or the next one.
/// \param seconds of the recording
/// \throws Error not_video if no frame decodes from there on
FullFrame frame_of(const PieceJob& job, double seconds);

/// A piece that was written to a folder of pieces.
struct WrittenPiece {
    std::string file;  ///< its name in the folder
    PieceFacts facts;
    std::optional<std::vector<PieceEvent>> events{};  ///< none = nobody searched for events
};

/// A file with its size and the SHA-256 of all its bytes.
struct HashedFile {
    std::string name;
    std::uintmax_t bytes = 0;
    std::string sha256;
};

/// \throws Error io if it can't be read
HashedFile hashed(const std::filesystem::path& path, const std::string& name);

/// Where the files of a folder of pieces come from.
struct PieceRecord {
    std::string camera;                         ///< empty = unknown
    WallClock clock;                            ///< of the footage; none = unknown
    image::Metadata settings;                   ///< with which the events were found
    footage::Unseen unseen{};                   ///< the areas in which nobody looked for events
    std::vector<media::SegmentPlace> places{};  ///< of the files, in seconds of the footage
    std::vector<HashedFile> footage{};          ///< the files of the pieces
    std::vector<WrittenPiece> pieces{};

    struct Still {
        std::string file;
        std::string marked;             ///< a copy in which the box is drawn, if there is one
        double seconds = 0;             ///< of the footage
        std::int64_t frame = 0;         ///< number in its file
        std::optional<PixelBox> box{};  ///< where the event is; none = unknown
    };
    std::optional<Still> still{};
};

/// Writes evidence.json and SHA256SUMS into the folder in which the files of the record lie. Hashes these files, but
/// not the footage.
///
/// \throws Error io
void write_record(const std::filesystem::path& folder, const PieceRecord& record, Observer& observer);

}  // namespace vvr::app
