#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/base/plane.h"
#include "core/fields/field.h"
#include "core/volume/layer.h"

namespace vvr::volume {

/// The identity of a voxel: its appearance and its event.
struct VoxelStyle {
    std::uint8_t look = 0;     ///< index of its appearance; 0 = without owner
    std::uint16_t number = 0;  ///< number of its event; 0 = none

    friend bool operator==(const VoxelStyle&, const VoxelStyle&) = default;
};

/// Returns the identity of a track's voxels in a layer. Called only when voxels are drawn, because tracks become events
/// at the end of the clip.
using VoxelStyleLookup = std::function<VoxelStyle(std::size_t track, const Layer& layer)>;

/// No voxel has an owner.
inline const VoxelStyleLookup no_styles;

/// Maps tracks to 16-bit numbers, which are stored as the owners of voxels. 0 means no owner.
class Owners {
  public:
    /// The number of a track, assigned on first use. 0 if no number is free.
    std::uint16_t number_of(std::size_t track);

    /// The track of a number.
    /// \pre number != 0
    std::size_t track_of(std::uint16_t number) const { return tracks_[number - std::size_t{1}]; }

    /// The number of free numbers.
    std::size_t room() const { return free_.size() + most - tracks_.size(); }

    /// Frees all numbers that are not in use.
    /// \param used whether each number is in use, by number
    void keep_only(const std::vector<bool>& used);

    /// The owners of a field's pixels: of the runs, and of non-zero pixels within `reach` of them. This includes the
    /// flickering edges of stationary objects and the soft edges of filters.
    OwnerPlane pixels_of(std::span<const fields::LabelRun> runs, const SparsePlane& scalar);

  private:
    static constexpr std::size_t most = 65'535;

    std::vector<std::size_t> tracks_;
    std::vector<std::uint16_t> free_;
    std::unordered_map<std::size_t, std::uint16_t> numbers_;
    Plane<std::uint16_t> whole_;  ///< all 0 between calls
};

}  // namespace vvr::volume
