#pragma once

#include <cstdint>
#include <deque>
#include <memory>

#include <oneapi/tbb/enumerable_thread_specific.h>

#include "core/fields/options.h"
#include "core/fields/pipeline.h"
#include "core/video/scaler.h"

namespace vvr {

/// Reads the frames of a clip between `options.start` and `options.end`, and `context` frames on each side. Must live
/// as long as the jobs that it gives.
class ClipReader {
  public:
    /// \param from_first whether all frames before `start` are wanted too
    ClipReader(FrameSource& source, const FieldOptions& options, int context, bool from_first);

    /// The job of the next frame; an empty function at the end.
    FrameJob operator()();

  private:
    std::shared_ptr<DecodedFrame> next();

    FrameSource& source_;
    double start_;
    std::optional<double> end_;
    std::size_t context_;
    bool started_;
    std::size_t past_end_ = 0;
    std::deque<std::shared_ptr<DecodedFrame>> waiting_;
    oneapi::tbb::enumerable_thread_specific<Scaler> scalers_;
};

}  // namespace vvr
