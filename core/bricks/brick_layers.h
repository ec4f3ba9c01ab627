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

/// What a voxel tells beside its scalar.
enum class ExtraChannel { nothing, colour, identity };

/// Red, green, blue and the scalar of a voxel; or its identity and its scalar: the look, the low and the high byte of
/// the event's number.
using ColouredTexel = std::array<std::uint8_t, 4>;

/// What goes into a brick's texture: its layers with one more before and after (the neighbour's layer, or the brick's
/// own end layer repeated where there is no neighbour), so that interpolation is continuous across bricks. It
/// covers only the box in which something isn't 0, with a border of 0 wherever the box ends before the layers do.
/// Texels are laid out on demand, some layers at a time: all at once they would be most of the memory that a picture
/// needs.
class BrickLayers {
  public:
    /// \param volume outlives this, and doesn't change
    /// \param identify outlives this; of a volume that keeps owners
    BrickLayers(const Volume& volume, const Brick& brick, const Identify& identify = no_identities);

    const Brick& brick() const { return brick_; }
    std::int64_t count() const { return brick_.count + 2; }  ///< of layers
    Size size() const { return size_; }                      ///< of a whole layer
    ExtraChannel extra_channel() const { return extra_channel_; }
    bool coloured() const { return extra_channel_ != ExtraChannel::nothing; }  ///< texels are ColouredTexels

    /// Whether there is something between two texels; else the nearest one is meant.
    bool interpolated() const { return fields::interpolates(volume_->values()); }

    /// Of the layers' texels, columns of x_C and rows of y_C; never empty.
    const PixelBox& box() const { return box_; }
    std::size_t area() const;  ///< of the box

    /// Lays out the texels of layers from `first` on, as many as `texels` has room for: x_C fastest, then y_C, then
    /// time. Columns and rows run against the image's, as x_C = 1 - (i + 0.5) / W and y_C = 1 - (j + 0.5) / H.
    void fill_texels(std::int64_t first, std::span<std::uint8_t> texels) const;

    /// The same with the video's colours, or with identities, of a volume that has them. A voxel without an owner that
    /// is next to others has the identity of one of these: interpolation makes their values reach into it.
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
