#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/plane.h"
#include "core/bricks/brick.h"
#include "core/bricks/owners.h"
#include "core/bricks/volume.h"

namespace vvr::bricks {

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
    BrickLayers(const Volume& volume, const Brick& brick, const Identify& identify = no_identities);

    const Brick& brick() const { return brick_; }
    std::int64_t count() const { return brick_.count + 2; }  ///< layers of the texture
    Size size() const { return size_; }                      ///< size of a whole layer
    ExtraChannel extra_channel() const { return extra_channel_; }
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
    const Identify* identify_;
    std::vector<const Layer*> layers_;
    PixelBox box_;
};

}  // namespace vvr::bricks
