#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/video/frame_times.h"
#include "core/video/input.h"
#include "core/video/scaler.h"

namespace vvr::video {

/// Samples key frames, spread in time over one or more consecutive files. Each is decoded on its own. All packets are
/// read, which is cheap compared with decoding and works without an index or accurate seeking.
class KeyFrames {
  public:
    /// \param count maximum number of frames
    explicit KeyFrames(int count) : count_(count), sampler_(count) {}

    /// Reads the packets of a file.
    /// \param begin time of its first frame, seconds; must not decrease from file to file
    /// \returns the time of its end, seconds; `begin` if no packet has a timestamp
    double scan(const Input& input, double rate, double begin);

    /// Decodes the frames, in order. Empty if there are fewer key frames than requested, or if they don't decode on
    /// their own. Call it only once.
    std::vector<Frame> decode(double rate, Scaler& scale);

  private:
    struct KeyPacket {
        std::size_t file = 0;
        double time = 0;
        av::Ptr<AVPacket> packet;
    };

    int count_;
    TimeSampler<KeyPacket> sampler_;
    std::vector<Input> files_;
    std::int64_t seen_ = 0;
};

}  // namespace vvr::video
