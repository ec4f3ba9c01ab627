#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/excerpt/footage.h"
#include "cli/excerpt/piece.h"
#include "cli/plan/observer.h"
#include "core/base/wall_clock.h"
#include "core/footage/unseen.h"
#include "core/image/picture.h"

namespace vvr::app {

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
