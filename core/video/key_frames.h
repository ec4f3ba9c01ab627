#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/video/frame_times.h"
#include "core/video/input.h"
#include "core/video/scaler.h"

namespace vvr::video {

/// Key frames spread in time over one file, or over several that follow each other: each is decoded by itself. Packets
/// are read through, which costs little beside decoding, and needs neither an index nor a container that seeks well.
class KeyFrames {
  public:
    /// \param count of frames, at most
    explicit KeyFrames(int count) : count_(count), sampler_(count) {}

    /// Reads the packets of a file.
    /// \param begin second at which its first frame is shown; not before those of the files before it
    /// \returns the second at which it ends; `begin` where no packet tells a time
    double scan(const Input& input, double rate, double begin);

    /// The frames, in order. None where there are fewer key frames than asked for, or where they don't decode by
    /// themselves. Call it once.
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
