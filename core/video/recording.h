#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/video/recorder_names.h"

// A recorder writes files of seconds, minutes or an hour: segments. All of a camera, in order, are one recording.
namespace vvr {

/// One file of a recording.
struct Segment {
    std::string path;
    std::optional<std::int64_t> begin{};  ///< seconds since 1970 (UTC); none = it follows the one before
};

/// The files of a recording, in order.
struct Recording {
    std::string name;  ///< what was asked for, in short
    std::string camera{};
    std::vector<Segment> segments;
    std::vector<std::string> warnings{};  ///< a sentence each
};

/// Finds out whether some names mean a recording of several files: files, folders of video files (and all folders in
/// them), patterns (`day/*.mp4`, `2026-11-21/*/gate`) and lists, text files whose names end in `.txt` and that hold the
/// path of a file in each line, below the folder of the list. Nothing for a single file, a stream, or pictures.
///
/// When each begins is told by its name, else by its container, else by when it was last written and how long it is;
/// if those contradict each other, the files follow each other in the order of their names.
///
/// \throws Error io when one can't be read, usage for what can't be a part of a recording, or when the names tell of
///         several cameras
std::optional<Recording> find_recording(std::span<const std::string> names, const RecorderNames& layouts);

}  // namespace vvr
