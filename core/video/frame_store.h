#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

#include "core/video/decoded_frame.h"

namespace vvr {

/// Pictures in order: of each only the bytes that differ from the picture before. What comes out is what went in, byte
/// for byte. LZ4 in its place takes a sixth more memory and twice the time.
class FrameStore {
  public:
    /// \returns false for a picture whose size or colours differ from the first one's: it is left out
    [[nodiscard]] bool push(ScaledPicture picture);

    /// Takes out the first picture; nothing after the last one.
    std::optional<ScaledPicture> pop();

    /// Of memory that is in use.
    std::size_t bytes() const { return bytes_; }

  private:
    /// Large enough to go back to the system when it is freed.
    struct Block {
        std::unique_ptr<std::uint8_t[]> memory;
        std::size_t size = 0;
        std::size_t written = 0;
        std::size_t read = 0;
    };

    Block& block_for(std::size_t bytes);

    std::optional<ScaledPicture> pushed_;  ///< the last one
    std::optional<ScaledPicture> popped_;  ///< the last one
    std::deque<Block> blocks_;
    std::size_t pictures_ = 0;
    std::size_t bytes_ = 0;
};

}  // namespace vvr
