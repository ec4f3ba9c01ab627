#pragma once

#include <cstdint>
#include <memory>

#include "core/video/av.h"
#include "core/video/input.h"

namespace vvr::video {

/// Gives libav the bytes of a pipe as they come, without a way back.
class PipeReader {
  public:
    PipeReader(std::shared_ptr<const Descriptor> pipe, std::shared_ptr<const Watchdog> watchdog);

    AVIOContext* context() { return context_.get(); }

  private:
    static int read(void* self, std::uint8_t* buffer, int size);

    std::shared_ptr<const Descriptor> pipe_;
    std::shared_ptr<const Watchdog> watchdog_;
    av::Ptr<AVIOContext> context_;
};

}  // namespace vvr::video
