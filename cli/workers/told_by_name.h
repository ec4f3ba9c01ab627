#pragma once

#include <string>

#include "core/video/recorder_names.h"

namespace vvr::workers {

/// Which camera a clip of an archive is of and when it begins, and what tells that, for people: "camera gate,
/// 2026-11-21 20:00:00 by file name (Frigate)".
/// \param clip its path below the archive's folder
std::string describe_name(const std::string& clip, const video::RecorderNames& names);

}  // namespace vvr::workers
