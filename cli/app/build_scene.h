#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "cli/app/annotate.h"
#include "cli/app/drawing.h"
#include "cli/app/job.h"
#include "cli/app/report.h"
#include "core/bricks/identity.h"
#include "core/fields/field_source.h"
#include "core/scene/scene.h"
#include "core/video/frame.h"

// The steps from a volume to its picture that one picture of a clip and a series of them share.
namespace vvr::app {

/// A frame and its number, counted from the volume's first.
struct KeyFrame {
    video::SharedFrame frame;
    std::int64_t number = 0;
};

/// The frames at the ends of a volume and between them; one without a picture is not drawn. And its bricks.
struct WindowFrames {
    const video::Frame& first;
    const video::Frame& last;
    std::span<const KeyFrame> between{};
    std::span<const bricks::Brick> bricks{};
    std::int64_t first_brick = 0;  ///< its number, counted from the clip's first
};

/// The layer at whose beginning a key frame stands.
std::int64_t layer_of(const KeyFrame& key, const bricks::Volume& volume);

/// The pieces that bricks are drawn in: they end where a key frame stands.
std::vector<bricks::Brick> sub_bricks_of(std::span<const bricks::Brick> bricks, std::span<const KeyFrame> between,
                                     const bricks::Volume& volume);

/// Reports the source and the context.
void describe(const fields::FieldSource& source, const gl::Context& context, RenderReport& report);

/// What a picture of `frames` frames needs of the fields.
fields::FieldNeeds needs_of(const RenderJob& job, const fields::FieldSource& source, std::int64_t frames);

std::unique_ptr<space::Layout> layout_of(const RenderJob& job, Size field_size);

/// All geometry that depends on the fields alone.
/// \param ticks of the ruler
/// \param identify of a volume that keeps owners
scene::Scene build_scene(const RenderJob& job, const bricks::Volume& volume, const WindowFrames& frames,
                         const space::Layout& layout, const Framing& framing,
                         const std::vector<labels::TimeTick>& ticks, const glance::Objects& objects,
                         const bricks::Identify& identify = bricks::no_identities);

/// Fig. 5: what the renderer makes of the bricks.
/// \param drawing its window shows them
/// \param window_layers that fill all of t_C
void add_overlays(const RenderJob& job, const Drawing& drawing, std::span<const bricks::Brick> bricks,
                  std::int64_t window_layers, scene::Scene& scene);

bool nothing_visible(const bricks::Volume& volume, const scene::TransferFunction& transfer);

/// Draws the window of the drawing and its scene, and writes on it.
/// \param pixel_data whether the picture comes with what each pixel shows
/// \param phase of the texture that moves along the tracelines, 0..1
image::Picture draw_picture(bool pixel_data, Drawing& drawing, const bricks::Volume& volume,
                            const labels::Lettering& lettering, double phase = 0);

}  // namespace vvr::app
