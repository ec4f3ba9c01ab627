#pragma once

#include <cstdint>
#include <deque>
#include <memory>

#include <oneapi/tbb/enumerable_thread_specific.h>

#include "core/fields/pipeline.h"
#include "core/video/frame_span.h"
#include "core/video/scaler.h"

namespace vvr::fields {

/// Reads the frames of a span of a clip, and `context` frames on each side. Must live as long as the jobs that it
/// gives.
class ClipReader {
  public:
    /// \param source at its first frame
    /// \param from_first whether all frames before the span are wanted too
    ClipReader(video::FrameSource& source, const video::FrameSpan& span, int context, bool from_first);

    /// The job of the next frame; an empty function at the end.
    FrameJob operator()();

    /// Of the frames read so far, the last one's number and time; -1 = there was none.
    std::int64_t last_index() const { return last_index_; }
    double last_pts() const { return last_pts_; }

  private:
    std::shared_ptr<video::DecodedFrame> read();
    void seek_to_span();
    void collect_context();

    video::FrameSource& source_;
    video::FrameSpan span_;
    std::size_t context_;
    bool begun_ = false;
    bool from_first_;
    std::size_t past_end_ = 0;
    std::int64_t last_index_ = -1;
    double last_pts_ = 0;
    std::deque<std::shared_ptr<video::DecodedFrame>> waiting_;
    oneapi::tbb::enumerable_thread_specific<video::Scaler> scalers_;
};

}  // namespace vvr::fields
