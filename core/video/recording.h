#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/wall_clock.h"
#include "core/video/recorder_names.h"
#include "core/video/stream_info.h"

// A recorder writes files of seconds, minutes or an hour: segments. All of a camera, in order, are one recording.
namespace vvr::video {

/// One file of a recording.
struct Segment {
    std::string path;
    std::optional<std::int64_t> begin{};           ///< seconds since 1970 (UTC); none = it follows the one before
    ClockSource begin_source = ClockSource::none;  ///< what tells that
    std::string camera{};                          ///< empty = nobody knows
    std::string layout{};                          ///< whose name it is, as in RecorderName
};

/// The files of a recording, in order.
struct Recording {
    std::string name;  ///< what was asked for, in short
    std::string camera{};
    std::vector<Segment> segments;
    std::vector<std::string> warnings{};  ///< a sentence each
};

/// Where a file of a recording begins.
struct SegmentBegin {
    double time = 0;        ///< seconds of the recording
    bool follows = false;   ///< the file before without a gap
    bool overlaps = false;  ///< that file
};

/// A file that begins within a second of the end of the one before follows it: names tell whole seconds, and recorders
/// begin a file at the next key frame.
/// \param origin of the recording, seconds since 1970 (UTC); none = not known
/// \param end of the file before, in seconds of the recording; none = it is the first
SegmentBegin begin_of(const Segment& segment, std::optional<std::int64_t> origin, std::optional<double> end);

/// Finds out whether some names mean a recording of several files: files, folders of video files (and all folders in
/// them), patterns (`day/*.mp4`, `2026-11-21/*/gate`) and lists, text files whose names end in `.txt` and that hold the
/// path of a file in each line, below the folder of the list. Nothing for a single file, a stream, or pictures.
///
/// When each begins is told by its name, else by its container, else by when it was last written and how long it is;
/// if those contradict each other, the files follow each other in the order of their names.
///
/// \param join whether files are one recording that seem to be of several cameras, or to have nothing to do with each
///        other
/// \throws Error io when one can't be read, usage for what can't be a part of a recording, or when the files are of
///         several cameras or unrelated
std::optional<Recording> find_recording(std::span<const std::string> names, const RecorderNames& layouts,
                                        bool join = false);

/// What the name of a single file tells.
Segment segment_from_name(const std::string& path, const RecorderNames& layouts);

}  // namespace vvr::video

// Files that are one recording together are of one camera.
namespace vvr::video {

/// A file's path from the root, so that its folders tell the same wherever one stands; streams stay as they are.
std::string whole_path(const std::string& name);

/// Fills in which camera each file is of, by its name and by folders in which the files differ, and returns the camera
/// of all; empty where nobody knows.
/// \param name of the recording, for the error
/// \param join whether files of several cameras are one recording all the same
/// \throws Error usage when they are of several, with a way to choose one of them
std::string find_camera(const std::string& name, std::vector<Segment>& segments, const RecorderNames& layouts,
                        bool join);

/// What the header of a file says that can be read now.
struct SegmentHeader {
    Segment* segment = nullptr;
    ClipHeader header;
};

/// Throws where no name tells when some files were recorded, and their sizes or rates differ besides: nothing says that
/// they belong together.
/// \param headers of these files, and first of one whose name tells it, where there is one: it stands for all of those
/// \throws Error usage
void require_related(const Recording& recording, std::span<const SegmentHeader> headers);

}  // namespace vvr::video
