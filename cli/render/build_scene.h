#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "cli/render/annotate.h"
#include "cli/render/render_clip.h"
#include "core/scene/scene.h"
#include "core/video/frame.h"

// The steps from a volume to its picture that one picture of a clip and a series of them share.
namespace vvr {

/// A frame and its number, counted from the volume's first.
struct KeyFrame {
    SharedFrame frame;
    std::int64_t number = 0;
};

/// The frames at the ends of a volume and between them; one without a picture is not drawn.
struct WindowFrames {
    const Frame& first;
    const Frame& last;
    std::span<const KeyFrame> between{};
};

/// A context that can draw what the job asks for.
/// \throws Error backend, limit
std::unique_ptr<Context> open_drawing(const RenderJob& job);

/// Puts into the report what there is before anything is drawn.
void describe(const FieldSource& source, const Context& context, RenderReport& report);

/// What a picture of `frames` frames needs of the fields.
FieldNeeds needs_of(const RenderJob& job, const FieldSource& source, std::int64_t frames);

std::unique_ptr<Layout> layout_of(const RenderJob& job, Size field_size);

/// How a window of so many bricks, with room for `layers` layers, is rendered.
RenderOptions options_of(const RenderJob& job, const Framing& framing, int bricks, std::int64_t layers);

/// The frame's colours where the volume takes them, else none.
const Plane<Bgr>& volume_colour(const RenderJob& job, const Frame& frame);

/// All geometry that depends on the fields alone.
Scene build_scene(const RenderJob& job, const Volume& volume, const WindowFrames& frames, const Layout& layout,
                  const Framing& framing);

/// Fig. 5: what the renderer makes of its bricks.
/// \param window_layers that all of t_C takes
void add_overlays(const RenderJob& job, const Renderer& renderer, std::span<const Brick> bricks,
                  std::int64_t window_layers, const Layout& layout, const TransferFunction& transfer, Scene& scene);

bool nothing_visible(const Volume& volume, const TransferFunction& transfer);

/// Draws what the renderer holds, with its layers where the job wants them, and writes on it.
Picture draw_picture(const RenderJob& job, Renderer& renderer, const Volume& volume, const Lettering& lettering,
                     double phase = 0);

}  // namespace vvr
