#pragma once

#include <memory>
#include <type_traits>

#include <glad/gl.h>

namespace vvr::gl {

struct DeleteSync {
    const GladGLContext* gl = nullptr;
    void operator()(GLsync sync) const { gl->DeleteSync(sync); }
};

/// A mark in the stream of commands, at which one can wait until OpenGL has come that far. Its context must be current
/// when it goes.
class Fence {
  public:
    Fence() = default;  ///< OpenGL is past it already

    /// Sets a mark behind all commands until now, and has OpenGL begin with them.
    explicit Fence(const GladGLContext& gl) : sync_(gl.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0), DeleteSync{&gl}) {
        gl.Flush();
    }

    void wait() const {
        if (sync_) sync_.get_deleter().gl->ClientWaitSync(sync_.get(), 0, GL_TIMEOUT_IGNORED);
    }

  private:
    std::unique_ptr<std::remove_pointer_t<GLsync>, DeleteSync> sync_;
};

}  // namespace vvr::gl
