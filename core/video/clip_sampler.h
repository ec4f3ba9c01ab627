#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/video/frame.h"
#include "core/video/frame_source.h"
#include "core/video/input.h"
#include "core/video/packet_scan.h"

namespace vvr::video {

/// Pictures in order, compressed: of each only how it differs from the one before. What comes out is what went in, byte
/// for byte.
class FrameStore {
  public:
    /// \returns false for a picture whose size or colours differ from the first one's: it is left out
    [[nodiscard]] bool push(ScaledPicture picture);

    /// Takes out the first picture; nothing after the last one.
    std::optional<ScaledPicture> pop();

    /// Compressed bytes.
    std::size_t bytes() const { return bytes_; }

  private:
    std::optional<ScaledPicture> pushed_;  ///< the last one
    std::optional<ScaledPicture> popped_;  ///< the last one
    std::deque<std::vector<char>> packed_;
    std::vector<char> scratch_;  ///< what a picture is compressed to
    std::size_t bytes_ = 0;
};

class StoredBytes;

/// All frames of a clip, decoded and scaled, until they are read.
class StoredClip {
  public:
    /// \param parts one after another
    /// \param times of all frames, seconds
    /// \param orientation of all frames
    StoredClip(std::vector<FrameStore> parts, std::vector<double> times, Orientation orientation)
        : parts_(std::move(parts)), times_(std::move(times)), orientation_(orientation) {}

    /// The next frame; nothing after the last one.
    std::unique_ptr<DecodedFrame> next();

    /// Skips the frames before `time`, in seconds.
    void skip(double time);

    /// Whether no frame has been read yet.
    bool is_whole() const { return read_ == 0; }

  private:
    std::vector<FrameStore> parts_;
    std::vector<double> times_;
    Orientation orientation_;
    std::size_t read_ = 0;
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

    /// \param stored is set where the whole clip had to be decoded and is small enough to be stored
    /// \returns nothing where the samples can't be told before all frames have been decoded
    std::vector<Frame> sample(int count, std::optional<StoredClip>& stored) const;

  private:
    std::vector<Frame> sample_key_frames(int count) const;
    std::vector<Frame> sample_all(const ClipPackets& packets, int count, std::optional<StoredClip>& stored) const;
    std::vector<Frame> sample_planned(const ClipPackets& packets, int count) const;
    std::vector<DecodingPlan> split_for_threads(const DecodingPlan& plan) const;
    bool decode(const DecodingPlan& plan, std::vector<Frame>& frames) const;
    bool decode(const DecodingPlan& plan, const std::vector<std::int64_t>& samples, StoredBytes& bytes,
                FrameStore& store, std::vector<Frame>& frames) const;
    DecodedFrame without_index(const Demuxer& demuxer, AvFrame image) const;

    Clip clip_;
};

}  // namespace vvr::video
