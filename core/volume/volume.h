#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"
#include "core/fields/field.h"
#include "core/volume/layer.h"
#include "core/volume/owners.h"

namespace vvr::volume {

/// A seed and its frame, counted from the volume's first. All bricks share one list (§6).
struct FrameSeed {
    std::int64_t frame = 0;
    fields::Seed seed;
};

/// How a volume is filled.
struct VolumeOptions {
    std::int64_t capacity = 800;                       ///< maximum number of layers; at least 2
    std::int64_t step = 1;                             ///< initial frames per layer; at least 1
    std::int64_t seed_interval = 1;                    ///< keep seeds of every n-th frame; doubles with the step
    std::int64_t span = 0;                             ///< number of layers that t_C covers; 0 = all
    fields::Values values = fields::Values::strength;  ///< kind of values, which determines how frames merge
    bool keep_flow = false;                            ///< for tracelines: keep the flow of frames whose seeds are kept
    bool keep_owners = false;                          ///< keep the owner of each voxel
    bool nonuniform = false;                           ///< layers of unequal length
    bool marked_late = false;                          ///< `mark_motion` says later what moves
};

/// The scalar fields of a clip in bounded memory. Initially, a layer has `step` frames. When there are `capacity`
/// layers, neighbours are merged in pairs, which keeps the stronger value (`joined` in core/fields/field.h). Later
/// layers have twice as many frames. So no motion is lost, and the clip's length need not be known.
///
/// In a nonuniform volume, layers have unequal lengths, so that motion gets more layers. When there are 1.5 times
/// `capacity` layers, the two neighbours with the smallest loss are merged. `settle` merges down to `capacity`.
///
/// A sliding window has a fixed span, and drops its first layers before new ones are added.
class Volume {
  public:
    /// \throws Error usage for a capacity below 2, or a step or seed interval below 1
    Volume(Size size, const VolumeOptions& options);

    /// Says that something moves between two times, seconds of the clip, in a nonuniform volume. Until `settle`, layers
    /// that ended a while ago may be merged already: the sooner it is said, the more room the motion has.
    void mark_motion(double first, double last);

    /// Forgets all that was said of motion.
    void forget_motion();

    /// Call it after the last frame. For a nonuniform volume, merges layers down to the capacity, and then layers
    /// without motion down to a quarter of all layers.
    void settle();

    /// Drops the first `layers` layers with their flow and seeds. The first remaining frame becomes frame 0.
    void drop_front(std::int64_t layers);

    /// Adds the next frame's field, whose scalar has this volume's size.
    /// \param colour the frame itself, for a volume in the video's colours; given for all frames or for none
    /// \param owners runs of pixels with an owner, for a volume that keeps owners
    /// \param moves whether the frame has motion, for a nonuniform volume
    void add(const fields::Field& field, const Plane<Bgr>& colour = {}, std::span<const fields::LabelRun> owners = {},
             bool moves = true);

    /// Adds an empty frame in place of a missing one.
    void add_missing(std::int64_t index, double pts) { add_gap(index, 1, pts, 0); }

    /// Adds `count` empty frames, `apart` seconds per frame.
    void add_gap(std::int64_t index, std::int64_t count, double pts, double apart);

    /// Removes all voxels of a track from a volume that keeps owners.
    void remove_track(std::size_t track);

    /// Removes all voxels of a box, field pixels: the camera's clock.
    void clear(const PixelBox& box);

    /// Adds the same pixels of a track to each layer from `first` to `last`, in a volume that keeps owners. Stronger
    /// values are kept.
    /// \param box position of the values, field pixels
    /// \param first, last seconds of the clip
    void insert_track(std::size_t track, const PixelBox& box, const Plane<std::uint8_t>& values, double first,
                      double last);

    Size size() const { return size_; }
    bool is_nonuniform() const { return options_.nonuniform; }

    /// Current frames per layer; for a nonuniform volume, the mean.
    std::int64_t step() const;

    std::int64_t frames() const { return frames_; }
    std::int64_t missing() const;  ///< number of missing frames
    std::int64_t layers() const { return static_cast<std::int64_t>(layers_.size()); }
    bool coloured() const { return coloured_; }
    fields::Values values() const { return options_.values; }
    bool keeps_owners() const { return options_.keep_owners; }

    /// The track of a number in a layer's `owner`.
    /// \pre owner != 0
    std::size_t track_of(std::uint16_t owner) const { return owners_.track_of(owner); }

    const Layer& layer(std::int64_t i) const { return layers_[static_cast<std::size_t>(i)]; }

    std::span<const FrameSeed> seeds() const { return seeds_; }
    const FlowVolume& flow() const { return flow_; }

    /// t_C at the end of the last layer.
    double t_end() const { return static_cast<double>(layers()) / static_cast<double>(span()); }

    /// t_C at the beginning of a layer.
    double t_of_layer(std::int64_t layer) const { return static_cast<double>(layer) / static_cast<double>(span()); }

    /// t_C of a (fractional) frame number counted from the first frame of the volume.
    double t_of_frame(double frame) const;

    /// t_C of a time in the clip, clamped to the volume.
    double t_of_seconds(double seconds) const;

    /// C-space position of (column, row, frame): field pixels, whose centres are integers, and a frame number counted
    /// from the first frame of the volume.
    glm::dvec3 c_of(const glm::dvec3& point) const;

    /// C-space vector of (u, v, v_t): field pixels to the right and down, and frames.
    glm::dvec3 c_vector(const glm::dvec3& vector) const;

  private:
    struct SeededFrame {
        std::int64_t frame = 0;
        std::int64_t index = 0;  ///< in the clip
    };

    bool seeded(std::int64_t frame) const;
    std::int64_t span() const { return options_.span > 0 ? options_.span : layers(); }
    std::int64_t layer_of(double seconds) const;
    bool continues_layer();
    void add_layer(Layer layer);
    void merge_pairs();
    void thin_seeds();
    std::int64_t room() const { return options_.nonuniform ? options_.capacity * 3 / 2 : options_.capacity; }
    OwnerPlane owners_in(std::span<const fields::LabelRun> runs, const SparsePlane& scalar);

    Size size_;
    VolumeOptions options_;  ///< `step` and `seed_interval` grow
    std::int64_t frames_ = 0;
    bool coloured_ = false;
    LayerMerger merger_;
    std::int64_t next_thinning_ = 0;  ///< in frames, for a nonuniform volume
    std::vector<Layer> layers_;
    std::vector<FrameSeed> seeds_;
    std::vector<SeededFrame> seeded_;  ///< frames whose seeds and flow are kept, in order
    Owners owners_;
    FlowVolume flow_;
};

/// A stretch of a nonuniform volume without motion, where time is compressed.
struct CompressedIdle {
    double t_begin = 0;  ///< t_C
    double t_end = 0;
    double begin = 0;  ///< seconds of the clip
    double seconds = 0;
};

/// The stretches compressed to less than half of the mean scale of time, in order; none if they are under 1 % of it
/// all.
std::vector<CompressedIdle> compressed_stretches(const Volume& volume);

}  // namespace vvr::volume
