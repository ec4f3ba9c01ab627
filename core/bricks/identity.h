#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace vvr::bricks {

struct Layer;

/// Whose a voxel is, as it is drawn and told.
struct Identity {
    std::uint8_t look = 0;     ///< which of the volume's looks it has; 0 = that of what is nobody's
    std::uint16_t number = 0;  ///< of its event; 0 = of none

    friend bool operator==(const Identity&, const Identity&) = default;
};

/// Tells whose the voxels of a track are in a layer. Tracks become events when the clip has ended, so it is asked as
/// late as the voxels are drawn.
using Identify = std::function<Identity(std::size_t track, const Layer& layer)>;

/// All is nobody's.
inline const Identify no_identities;

}  // namespace vvr::bricks
