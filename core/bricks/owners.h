#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/base/plane.h"
#include "core/bricks/layer.h"
#include "core/fields/field.h"

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

/// Short numbers for tracks, as the owners of voxels are kept in 16 bits: 0 is nobody, else 1 + the place in a list.
class Owners {
  public:
    /// The number of a track; a new one if it has none. 0 when there is no number left.
    std::uint16_t number_of(std::size_t track);

    /// The track of a number that isn't 0.
    std::size_t track_of(std::uint16_t number) const { return tracks_[number - std::size_t{1}]; }

    /// How many numbers are left.
    std::size_t room() const { return free_.size() + most - tracks_.size(); }

    /// Takes the numbers from all tracks but those of `used`, which tells it for each number.
    void keep_only(const std::vector<bool>& used);

    /// Whose the pixels of a field are: its runs, and what lies within `reach` of them and isn't 0. What stands has a
    /// rim that is never quite still, and a filter's edges are soft: without that they would be nobody's.
    OwnerPlane pixels_of(std::span<const fields::LabelRun> runs, const SparsePlane& scalar);

  private:
    static constexpr std::size_t most = 65'535;

    std::vector<std::size_t> tracks_;
    std::vector<std::uint16_t> free_;
    std::unordered_map<std::size_t, std::uint16_t> numbers_;
    Plane<std::uint16_t> whole_;  ///< 0 between calls
};

}  // namespace vvr::bricks
