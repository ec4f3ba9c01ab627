#pragma once

#include <memory>
#include <optional>
#include <tuple>

#include "core/video/area_scaler.h"
#include "core/video/av.h"

// What libav's many pixel formats hold, and one format for those that don't have luma in a plane of 8 bits.
namespace vvr::video {

/// Whether plane 0 is luma of 8 bits, and chroma, where there is any, lies in planes 1 and 2 or in pairs in plane 1.
bool has_luma_plane(AVPixelFormat format);

bool is_full_range(const AVFrame& frame);

/// Where nothing is said, large pictures are in HDTV's colours and small ones in television's, as players assume.
AVColorSpace colour_space(const AVFrame& frame);

/// Brings any pixel format to 8-bit full-range luma, and chroma where colour is asked for, at the frame's own size.
class PixelConverter {
  public:
    /// Valid until the next call.
    ///
    /// \throws Error not_video for a format that can't be converted, limit when there is no memory
    const AVFrame& operator()(const AVFrame& from, bool colour);

  private:
    using Key = std::tuple<int, int, int, int, int, bool>;

    void prepare(const AVFrame& from, bool colour);

    std::optional<Key> key_;
    std::unique_ptr<SwsContext, SwsFree> context_;
    AvFrame to_;
};

}  // namespace vvr::video
