#pragma once

#include <future>
#include <memory>

#include "cli/render/annotate.h"
#include "cli/render/render_clip.h"
#include "gl/context.h"

namespace vvr {

/// All that draws the pictures of a job, before there is anything to be drawn.
struct Drawing {
    std::unique_ptr<Context> context;
    std::unique_ptr<Layout> layout;
    Framing framing;
    std::unique_ptr<Renderer> renderer;
};

/// Makes a drawing on a thread of its own while the clip is read: the libraries take a second core's time to load, and
/// the driver to compile shaders.
class DrawingAhead {
  public:
    enum class Part {
        all,
        context,  ///< the rest when it is taken, and less of it: memory counts for more than a moment then
    };

    /// \param job outlives it
    DrawingAhead(const RenderJob& job, Size field_size, Part part);
    ~DrawingAhead();
    DrawingAhead(const DrawingAhead&) = delete;
    DrawingAhead& operator=(const DrawingAhead&) = delete;

    /// Waits until there is a context.
    /// \throws Error backend, limit
    void wait_for_context() { opened_.get_future().get(); }

    /// Waits for all of it, whose context is current in this thread then. Once.
    /// \throws Error backend, limit, io
    Drawing take();

  private:
    Drawing open(Part part);
    void make_renderer(Drawing& drawing, std::int64_t tile_samples) const;

    const RenderJob* job_;
    Size field_size_;
    std::promise<void> opened_;
    std::future<Drawing> drawing_;
};

}  // namespace vvr
