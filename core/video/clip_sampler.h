#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/video/frame_source.h"
#include "core/video/frame_store.h"
#include "core/video/input.h"
#include "core/video/packet_scan.h"

namespace vvr {

class KeepingRoom;

/// A clip that has been decoded, at the field size, and not yet been given out.
class KeptClip {
  public:
    /// \param parts one after another
    /// \param times of all frames, seconds
    /// \param orientation of all frames
    KeptClip(std::vector<FrameStore> parts, std::vector<double> times, Orientation orientation)
        : parts_(std::move(parts)), times_(std::move(times)), orientation_(orientation) {}

    /// The next frame, not yet upright; without an image at the end.
    DecodedFrame next();

    /// Passes over frames before `time`.
    void pass(double time);

    bool is_new() const { return given_ == 0; }

  private:
    std::vector<FrameStore> parts_;
    std::vector<double> times_;
    Orientation orientation_;
    std::size_t given_ = 0;
};

/// Takes samples of a clip (`FrameSource::sample`) by decoding as little of it as it can.
class ClipSampler {
  public:
    /// What all frames of a clip have in common.
    struct Clip {
        const Input& input;
        const SourceOptions& options;
        Size field_size;
        Orientation orientation;
        double origin = 0;      ///< the first frame's time on the container's clock, seconds
        bool threaded = false;  ///< whether its decoder has threads of its own
    };

    /// `clip` refers to what outlives this.
    explicit ClipSampler(const Clip& clip) : clip_(clip) {}

    /// None where all has to be decoded in order to see what is there.
    /// \param kept is set where the clip was decoded and is small enough to be kept
    std::vector<Frame> sample(int count, std::optional<KeptClip>& kept) const;

  private:
    std::vector<Frame> sample_key_frames(int count) const;
    std::vector<Frame> sample_keeping(const ClipPackets& packets, int count, std::optional<KeptClip>& kept) const;
    std::vector<Frame> sample_planned(const ClipPackets& packets, int count) const;
    std::vector<DecodingPlan> share_out(const DecodingPlan& plan) const;
    bool decode(DecodingPlan plan, std::vector<Frame>& frames) const;
    bool decode(DecodingPlan plan, const std::vector<std::int64_t>& samples, KeepingRoom& room, FrameStore& store,
                std::vector<Frame>& frames) const;
    DecodedFrame without_index(const Demuxer& demuxer, AvFrame image) const;

    Clip clip_;
};

}  // namespace vvr
