#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/archive/scan.h"
#include "core/video/recorder_names.h"

namespace vvr {

/// All clips that a camera began on a day.
struct CameraDay {
    std::string camera;              ///< empty = nobody knows
    std::string date;                ///< "2026-11-21", in this machine's time zone
    Clip clip;                       ///< all together: where its files stand, bytes, when the newest was written
    std::vector<std::string> files;  ///< below the archive's folder
};

/// Groups clips by camera and day. A clip of which nothing tells when it begins is of the day when it was last written.
/// \param settled nanoseconds since 1970; clips that were written later are still being written, and left out
/// \param problems cameras whose names can't be those of folders
std::vector<CameraDay> group_by_day(const std::vector<Clip>& clips, const RecorderNames& names, std::int64_t settled,
                                    std::vector<ScanProblem>& problems);

}  // namespace vvr
