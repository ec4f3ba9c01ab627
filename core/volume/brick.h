#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/plane.h"
#include "core/volume/layer.h"
#include "core/volume/owners.h"
#include "core/volume/volume.h"

namespace vvr::volume {

/// Consecutive layers of the volume that form one 3D texture: the logical brick of §6.
struct Brick {
    std::int64_t first = 0;
    std::int64_t count = 0;

    friend bool operator==(const Brick&, const Brick&) = default;
};

/// Cuts `layers` layers into `bricks` bricks whose lengths differ by at most one. Makes fewer bricks if there are fewer
/// layers.
std::vector<Brick> cut_into(std::int64_t layers, int bricks);

/// Cuts `layers` layers into bricks of `length`; the last one may be shorter.
std::vector<Brick> cut_by(std::int64_t layers, std::int64_t length);

/// Maximum number of layers of a sub-brick.
inline constexpr std::int64_t sub_brick_layers = 32;

/// Cuts bricks into sub-bricks, which are drawn like bricks. They skip more empty space and fit into the GPU's caches.
/// The lengths of a brick's sub-bricks differ by at most one layer.
std::vector<Brick> cut_into_sub_bricks(std::span<const Brick> bricks);

/// Cuts bricks at the beginning of the given layers.
/// \param layers ascending
std::vector<Brick> cut_at(std::span<const Brick> bricks, std::span<const std::int64_t> layers);

/// Cuts a volume at multiples of `length` seconds of a clock, for example at full hours.
/// \param clock the clock's time at second 0 of the clip, seconds
std::vector<Brick> cut_by_clock(const Volume& volume, double length, double clock);

/// Cuts a volume at multiples of `length` frames.
std::vector<Brick> cut_by_frames(const Volume& volume, std::int64_t length);

/// The brick-based seed filter of §6: the seeds of a volume that their bricks turn into geometry.
/// \param bricks bricks of the volume, in order of time
/// \param first number of the first brick, counted from the clip's first
/// \param flags replaces the seeds' own flags
std::vector<FrameSeed> used_seeds(const Volume& volume, std::span<const Brick> bricks, std::int64_t first,
                                  const std::optional<fields::SeedFlags>& flags);

/// What a voxel stores besides its scalar.
enum class ExtraChannel { nothing, colour, identity };

/// Red, green, blue and scalar of a voxel, or its identity and scalar: the look, then the low and high byte of the
/// event's number.
using ColouredTexel = std::array<std::uint8_t, 4>;

/// The content of a brick's texture. It has one extra layer before and after the brick, so that interpolation is
/// continuous across bricks: the neighbour's layer, or the brick's end layer repeated if there is no neighbour. It
/// covers only the box of non-zero voxels, with a border of zeros unless the box ends with the layers. Texels are
/// generated on demand, a few layers at a time, because all at once they would dominate the memory use of a picture.
class BrickLayers {
  public:
    /// \param volume must outlive this object, unchanged
    /// \param identify must outlive this object; only for a volume that keeps owners
    BrickLayers(const Volume& volume, const Brick& brick, const VoxelStyleLookup& identify = no_styles);

    const Brick& brick() const { return brick_; }
    std::int64_t count() const { return brick_.count + 2; }                    ///< layers of the texture
    Size size() const { return size_; }                                        ///< size of a whole layer
    bool coloured() const { return extra_channel_ != ExtraChannel::nothing; }  ///< texels are ColouredTexels

    /// Whether to interpolate between texels; otherwise the nearest texel is used.
    bool interpolated() const { return fields::interpolates(volume_->values()); }

    /// The covered box in texels: columns along x_C, rows along y_C. Never empty.
    const PixelBox& box() const { return box_; }
    std::size_t area() const;  ///< texels in the box

    /// Fills `texels` with layers from `first` on: x_C varies fastest, then y_C, then time. Columns and rows are
    /// reversed relative to the image: x_C = 1 - (i + 0.5) / W and y_C = 1 - (j + 0.5) / H.
    void fill_texels(std::int64_t first, std::span<std::uint8_t> texels) const;

    /// The same with the video's colours or with identities, if the volume has them. A voxel without an owner gets the
    /// identity of an adjacent voxel, because interpolation extends that voxel's values into it.
    void fill_texels(std::int64_t first, std::span<ColouredTexel> texels) const;

  private:
    void fill_colours(const Layer& layer, std::span<ColouredTexel> texels) const;
    void fill_identities(std::int64_t first, std::span<ColouredTexel> texels) const;

    Brick brick_;
    Size size_;
    ExtraChannel extra_channel_;
    const Volume* volume_;
    const VoxelStyleLookup* identify_;
    std::vector<const Layer*> layers_;
    PixelBox box_;
};

}  // namespace vvr::volume
