#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/footage/recorder_names.h"
#include "core/footage/segments.h"

// Recorders write files of seconds to an hour, called segments. A camera's segments, in order, are one recording.
namespace vvr::footage {

/// The files of a recording, in order.
struct Recording {
    std::string name;  ///< short name of the input
    std::string camera{};
    std::vector<Segment> segments;
    std::vector<std::string> warnings{};  ///< one sentence each
    double rate = 0;  ///< frames per second in place of those that the files state; 0 = as they state
};

/// The start of a file in a recording.
struct SegmentBegin {
    double time = 0;        ///< seconds of the recording
    bool follows = false;   ///< follows the previous file without a gap
    bool overlaps = false;  ///< overlaps the previous file
};

/// Places a file in a recording. A file that begins within a second (its slack) of the previous file's end follows it,
/// because names have whole seconds and recorders begin files at key frames.
/// \param origin start of the recording, seconds since 1970 (UTC); none = unknown
/// \param end end of the previous file, seconds of the recording; none = this is the first file
SegmentBegin begin_of(const Segment& segment, std::optional<std::int64_t> origin, std::optional<double> end);

/// Finds the files of a recording. Names may be files, folders of video files (with their subfolders), globs
/// (`day/*.mp4`, `2026-11-21/*/gate`) and lists: `.txt` files with one path per line, within the list's folder. Empty
/// for a single file, a stream or pictures.
///
/// The start of each file comes from its name, or else its container, or else its modification time and duration. If
/// these contradict each other, the files follow in the order of their names.
///
/// \param join whether to accept files of several cameras or unrelated files as one recording
/// \param rate as SourceOptions::rate
/// \throws Error io if an input can't be read, usage if an input can't be a part of a recording, or if the files are of
///         several cameras or unrelated
std::optional<Recording> find_recording(std::span<const std::string> names, const RecorderNames& schemes,
                                        bool join = false, double rate = 0);

/// The video files of a recording's inputs, each once, in natural order of their names. Inputs of other kinds have
/// none.
///
/// \throws Error io if an input can't be read
std::vector<std::string> files_of_inputs(std::span<const std::string> names);

/// The segment of a single file, by its name.
Segment segment_from_name(const std::string& path, const RecorderNames& schemes);

}  // namespace vvr::footage
