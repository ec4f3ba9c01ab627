#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "core/video/decoded_frame.h"

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

}  // namespace vvr::video
