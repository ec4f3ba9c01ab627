#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>

#include "core/video/decoded_frame.h"

namespace vvr {

/// Pictures in order, of each only the tiles in which it differs from the one before: decoders copy what stands still,
/// so those of a fixed camera take a fraction of their bytes. What comes out is what went in, byte for byte.
class FrameStore {
  public:
    /// \param picture 8 bits a sample, each plane for itself
    /// \returns false for one that is not of the first one's size, format and colours: it is left out
    /// \throws Error limit when there is no memory
    [[nodiscard]] bool push(const AVFrame& picture);

    /// The first picture that is still there; nothing after the last one.
    /// \throws Error limit when there is no memory
    AvFrame pop();

    std::size_t size() const { return pictures_; }

    /// Of memory, which goes back to the system as pictures are taken out.
    std::size_t bytes() const;

  private:
    struct Unmap {
        std::size_t bytes = 0;
        void operator()(std::uint8_t* memory) const;
    };
    struct Block {
        std::unique_ptr<std::uint8_t[], Unmap> memory;
        std::size_t written = 0;
        std::size_t read = 0;
    };

    void make_room(std::size_t bytes);

    std::size_t pictures_ = 0;
    std::deque<Block> blocks_;  ///< of each picture a table of its tiles, then the tiles
    AvFrame pushed_;            ///< the last one
    AvFrame popped_;            ///< likewise
};

}  // namespace vvr
