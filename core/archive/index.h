#pragma once

#include <string>
#include <vector>

#include "core/archive/sidecar.h"

namespace vvr {

/// A page that lists an archive's pictures by day and camera, newest first. It belongs into their folder. Same
/// sidecars, same text.
std::string make_index(const std::vector<Sidecar>& sidecars);

/// When a clip begins, in seconds since 1970: as its container says, else its length before its file was last written.
std::int64_t begin_of(const Sidecar& sidecar);

}  // namespace vvr
