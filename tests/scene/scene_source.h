#pragma once

#include <memory>

#include "core/media/frame_source.h"
#include "tests/scene/scene.h"

namespace vvr::generator {

/// The frames of a scene as if they came from a video: for tests that need no file and no encoder.
/// Of the options `field_size` and `colour` count.
std::unique_ptr<media::FrameSource> open_scene(Scene scene, const media::SourceOptions& options = {});

}  // namespace vvr::generator
