#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/archive/scan.h"
#include "core/video/recorder_names.h"

namespace vvr::archive {

/// All clips that a camera began on a day.
struct CameraDay {
    std::string camera;              ///< empty = nobody knows
    std::string date;                ///< "2026-11-21", in this machine's time zone
    Clip clip;                       ///< all together: where its files stand, bytes, when the newest was written
    std::vector<std::string> files;  ///< below the archive's folder
};

/// Clips by camera and day.
struct CameraDays {
    std::vector<CameraDay> days;
    std::vector<ScanProblem> problems;  ///< cameras whose names can't be those of folders
    std::size_t waiting = 0;            ///< clips that are still being written, and left out
};

/// Groups clips by camera and day. A clip of which nothing tells when it begins is of the day when it was last written.
CameraDays group_by_day(const std::vector<Clip>& clips, const video::RecorderNames& names, const Settling& settling);

}  // namespace vvr::archive
