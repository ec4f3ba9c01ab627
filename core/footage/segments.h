#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/wall_clock.h"
#include "core/footage/recorder_names.h"
#include "core/media/frame_source.h"

namespace vvr::footage {

/// One file of a recording.
struct Segment {
    std::string path;
    std::optional<std::int64_t> begin{};           ///< seconds since 1970 (UTC); none = it follows the previous segment
    ClockSource begin_source = ClockSource::none;  ///< source of `begin`
    std::string camera{};                          ///< empty = unknown
    std::string scheme{};                          ///< as RecorderName::scheme
    bool sub = false;                              ///< as RecorderName::sub
    bool no_clock = false;                         ///< as RecorderName::no_clock
    double slack = 1;  ///< seconds; a file that begins so near to the end of the one before follows it
};

/// A moment of a recording, in one of its files.
struct FileMoment {
    const media::SegmentPlace* file = nullptr;  ///< null if there are no files
    double offset = 0;                          ///< seconds from the file's first frame
};

/// The file that shows a moment: the first that has not ended by then. In a gap it is the beginning of the next file,
/// after the end the last file. Pages choose files in the same way (core/web/page/pieces.js).
/// \param files in order
/// \param seconds of the recording
inline FileMoment file_at(std::span<const media::SegmentPlace> files, double seconds) {
    if (files.empty()) return {};
    const auto found = std::ranges::find_if(
        files, [&](const media::SegmentPlace& file) { return seconds < file.end - media::shortest_frame; });
    const media::SegmentPlace& file = found == files.end() ? files.back() : *found;
    return {&file, std::max(0.0, seconds - file.begin)};
}

/// How the files of a camera that sends fewer frames per second than they state fill their time.
struct SteadyRate {
    double rate = 0;    ///< frames per second at which each file lasts until the next begins
    double stated = 0;  ///< frames per second by the files
    double length = 0;  ///< of a file, as stated, seconds
    double pace = 0;    ///< from the begin of a file to that of the next one, seconds
};

/// Finds out whether a camera sends fewer frames per second than its recorder states: then each file ends before the
/// next begins, all in the same ratio.
/// \param segments in order
std::optional<SteadyRate> find_steady_rate(const std::vector<Segment>& segments);

// A recording has one camera.

/// A file's absolute path, so that results don't depend on the working folder. Streams keep their names.
std::string whole_path(const std::string& name);

/// Sets the camera of each segment by file name and by folders that differ. Returns the common camera, or an empty
/// string if unknown.
/// \param name name of the recording, for the message
/// \param join whether to accept files of several cameras
/// \throws Error usage if they are of several cameras; the message says how to choose one
std::string find_camera(const std::string& name, std::vector<Segment>& segments, const RecorderNames& schemes,
                        bool join);

}  // namespace vvr::footage
