#pragma once

#include <algorithm>
#include <span>

#include "core/media/frame_source.h"

namespace vvr::footage {

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

}  // namespace vvr::footage
