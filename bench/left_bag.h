#pragma once

#include <string>

#include "core/bricks/volume.h"

namespace vvr::bench {

constexpr int left_bag_frames = 1600;

/// The volume of the left-bag scene, 384x288 voxels a frame, seen through a filter, with the seeds of every 16th frame.
/// \param frames fewer are for tests: the same happens, faster
Volume left_bag_volume(const std::string& filter, int frames = left_bag_frames);

/// The share of the voxels that aren't 0.
double occupied_share(const Volume& volume);

}  // namespace vvr::bench
