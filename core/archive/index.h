#pragma once

#include <string>
#include <vector>

#include "core/archive/sidecar.h"
#include "core/video/recorder_names.h"

namespace vvr {

/// A page that lists an archive's pictures by day and camera, newest first. It belongs into their folder. Same
/// sidecars, same text.
/// \param names that tell the camera and the time of a clip
std::string make_index(const std::vector<Sidecar>& sidecars, const RecorderNames& names = RecorderNames());

/// When a clip begins, in seconds since 1970 (UTC): as its name says, else its container, else its length before its
/// file was last written.
std::int64_t begin_of(const Sidecar& sidecar, const RecorderNames& names = RecorderNames());

}  // namespace vvr
