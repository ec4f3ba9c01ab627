#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"
#include "core/bricks/brick.h"
#include "core/bricks/layer.h"
#include "core/bricks/owners.h"
#include "core/fields/field.h"

namespace vvr::bricks {

/// The optical flow at some frames of the window: a vector field over (column, row, frame), which tracelines follow
/// (§5.2). Half floats: their 11 bits are finer than any estimate of flow, in half the memory.
class FlowVolume {
  public:
    /// Keeps the flow of `frame`, a later one than those before, all of one size.
    void add(std::int64_t frame, const fields::Flow& flow);

    /// Forgets the frames for which `gone` is true.
    void erase_if(const std::function<bool(std::int64_t)>& gone);

    /// Forgets the frames before `frame`, which is frame 0 from now on.
    void drop_front(std::int64_t frame);

    bool empty() const { return layers_.empty(); }
    std::size_t layers() const { return layers_.size(); }
    std::size_t bytes() const;

    /// (u, v) in field pixels per frame at (column, row, frame), linear between pixel centres and between the frames
    /// that are kept; beyond the outermost ones, theirs. Zero where nothing is kept.
    glm::dvec2 at(const glm::dvec3& point) const;

  private:
    struct Layer {
        std::int64_t frame = 0;
        Plane<std::uint32_t> packed;  ///< u in the low half, v in the high one
    };

    std::vector<Layer> layers_;
};

/// A seed and the frame that it belongs to; the list is shared by all bricks (§6).
struct FrameSeed {
    std::int64_t frame = 0;
    fields::Seed seed;
};

/// How a volume is filled.
struct VolumeOptions {
    std::int64_t capacity = 800;                       ///< layers at most, at least 2
    std::int64_t step = 1;                             ///< frames per layer to begin with, at least 1
    std::int64_t seed_interval = 1;                    ///< seeds are kept of every n-th frame; doubles with the step
    std::int64_t span = 0;                             ///< layers over which t_C runs; 0 = as many as there are
    fields::Values values = fields::Values::strength;  ///< of the fields, which says how frames share a layer
    bool keep_flow = false;                            ///< of the frames whose seeds are kept, for tracelines
    bool keep_owners = false;                          ///< whose each voxel is
    bool nonuniform = false;                           ///< layers of unequal length
};

/// The scalar fields of a clip in bounded memory. While it fits, a layer is a frame. When `capacity` layers are full,
/// neighbours are joined in pairs, keeping the stronger value (`joined` in core/fields/field.h), and from then on a
/// layer takes twice as many frames: so nothing that moved is lost, the clip's length needn't be known, and memory
/// never grows beyond the capacity.
///
/// Or layers are of unequal length, so that the room goes where something moves: when there are half as many again as
/// `capacity`, the two neighbours whose joining loses least become one, and at the end the same is done until there are
/// `capacity`.
///
/// As a window that slides over a clip it has a fixed span, and its first layers leave before the next ones come.
class Volume {
  public:
    /// \throws Error usage where the options leave no room
    Volume(Size size, const VolumeOptions& options);

    /// After the last frame, of layers of unequal length: joins them until they are no more than the capacity, and
    /// those in which nothing moves no more than a quarter of them, where others are.
    void settle();

    /// Drops the first `layers` layers with their flow and seeds. Frames are counted from the first that stays.
    void drop_front(std::int64_t layers);

    /// Adds the next frame's field, whose scalar has this volume's size.
    /// \param colour the frame itself, for a volume in the video's colours: from the first frame on or never
    /// \param owners whose pixels are whose, of a volume that keeps that
    /// \param moves whether something moves in it, where layers are of unequal length
    void add(const fields::Field& field, const Plane<Bgr>& colour = {}, std::span<const fields::LabelRun> owners = {},
             bool moves = true);

    /// Adds a frame that never came, where time went on without one: nothing is to be seen in it.
    void add_missing(std::int64_t index, double pts) { add_gap(index, 1, pts, 0); }

    /// Adds `count` of them, `apart` seconds from one to the next.
    void add_gap(std::int64_t index, std::int64_t count, double pts, double apart);

    /// Takes out all that belongs to a track, of a volume that keeps owners.
    void remove_track(std::size_t track);

    /// Puts the same pixels into each layer from `first` to `last`, as those of a track; they don't replace stronger
    /// ones. Of a volume that keeps owners.
    /// \param box of the values, in field pixels
    /// \param first, last seconds of the clip
    void insert_track(std::size_t track, const PixelBox& box, const Plane<std::uint8_t>& values, double first,
                      double last);

    Size size() const { return size_; }
    bool is_nonuniform() const { return options_.nonuniform; }

    /// Frames per layer now; of layers of unequal length, in the mean.
    std::int64_t step() const;

    std::int64_t frames() const { return frames_; }
    std::int64_t missing() const;  ///< of the frames, those that never came
    std::int64_t layers() const { return static_cast<std::int64_t>(layers_.size()); }
    bool coloured() const { return coloured_; }
    fields::Values values() const { return options_.values; }
    bool keeps_owners() const { return options_.keep_owners; }

    /// The track that a number of a layer's `owner` stands for; the number isn't 0.
    std::size_t track_of(std::uint16_t owner) const { return owners_.track_of(owner); }

    const Layer& layer(std::int64_t i) const { return layers_[static_cast<std::size_t>(i)]; }

    std::span<const FrameSeed> seeds() const { return seeds_; }
    const FlowVolume& flow() const { return flow_; }

    /// t_C where the last layer ends.
    double t_end() const { return static_cast<double>(layers()) / static_cast<double>(span()); }

    /// t_C where a layer begins.
    double t_of_layer(std::int64_t layer) const { return static_cast<double>(layer) / static_cast<double>(span()); }

    /// t_C of a (fractional) frame number counted from the first frame of the volume.
    double t_of_frame(double frame) const;

    /// t_C of a moment of the clip, between the times of the layers; of one before or after them, that of their ends.
    double t_of_seconds(double seconds) const;

    /// C-space position of (column, row, frame): field pixels, whose centres are whole numbers, and a frame number
    /// counted from the first frame of the volume.
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
    Layer& add_layer(Layer layer);
    void merge_pairs();
    void thin_seeds();
    std::int64_t room() const { return options_.nonuniform ? options_.capacity * 3 / 2 : options_.capacity; }
    OwnerPlane owners_in(std::span<const fields::LabelRun> runs, const SparsePlane& scalar);

    Size size_;
    VolumeOptions options_;  ///< its step and its interval of seeds grow
    std::int64_t frames_ = 0;
    bool coloured_ = false;
    LayerMerger merger_;
    std::int64_t next_thinning_ = 0;  ///< frames, of layers of unequal length
    std::vector<Layer> layers_;
    std::vector<FrameSeed> seeds_;
    std::vector<SeededFrame> seeded_;  ///< whose seeds and flow are kept, in order
    Owners owners_;
    FlowVolume flow_;
};

/// A stretch of a volume whose layers are of unequal length, in which nothing moves and time is pressed together.
struct CompressedIdle {
    double t_begin = 0;  ///< t_C
    double t_end = 0;
    double begin = 0;  ///< seconds of the clip
    double seconds = 0;
};

/// Those that have less than half the room that time has in the mean, in order.
std::vector<CompressedIdle> compressed_stretches(const Volume& volume);

/// Cuts a volume where multiples of `length` seconds pass on a clock that shows `clock` at second 0 of the clip: by the
/// hour, say.
std::vector<Brick> cut_by_clock(const Volume& volume, double length, double clock);

/// Cuts a volume where multiples of `length` frames pass.
std::vector<Brick> cut_by_frames(const Volume& volume, std::int64_t length);

/// The brick-based seed filter of §6: of a volume's seeds those of which their bricks make geometry.
/// \param bricks of the volume, in the order of time
/// \param first number of the first of them, counted from the clip's first
/// \param flags instead of the seeds' own
std::vector<FrameSeed> used_seeds(const Volume& volume, std::span<const Brick> bricks, std::int64_t first,
                                  const std::optional<fields::SeedFlags>& flags);

}  // namespace vvr::bricks
