#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/footage/recorder_names.h"
#include "core/media/frame_source.h"

namespace vvr::footage {

/// Pictures that a camera saved now and then, each with the time of its name.
struct Snapshots {
    std::string camera;                       ///< empty = unknown
    std::int64_t begin = 0;                   ///< of the first, seconds since 1970 (UTC)
    double usual = 0;                         ///< time between two of them, seconds
    std::vector<media::SegmentPlace> places;  ///< in order; numbers are left out where pictures are missing
    std::vector<std::string> warnings{};      ///< one sentence each
};

/// Finds out when pictures were taken. A distance of more than three times the usual one is a gap. Several pictures of
/// one second are spread over it.
/// \param name of the input, for messages
/// \param files in natural order
/// \param join as in `find_recording`
/// \returns nothing if most names have no time, or if all have the same one
/// \throws Error usage if they are of several cameras
std::optional<Snapshots> find_snapshots(const std::string& name, const std::vector<std::string>& files,
                                        const RecorderNames& schemes, bool join);

}  // namespace vvr::footage
