#pragma once

#include <optional>
#include <string>

#include "cli/plan/options.h"
#include "core/fields/options.h"
#include "core/fields/seeds.h"
#include "core/image/picture.h"
#include "core/media/frame_source.h"
#include "core/space/layout.h"
#include "gl/render_options.h"

namespace vvr::app {

/// A whole run: input, fields, drawing and outputs.
struct RenderJob {
    InputOptions input;
    fields::FieldOptions fields;
    std::string seeds;  ///< lists that replace the computed seeds, as in ListedSeeds; empty = none
    std::optional<fields::SeedFlags> seed_flags{};  ///< one per brick; none = those of the seeds
    BrickOptions bricks;
    Choice<space::LayoutRow> layout = space::layouts().front();
    space::LayoutOptions shape;
    LookOptions look;
    gl::RenderOptions picture;  ///< camera, background and glyphs come from the other members
    DetectorOptions detector;
    BackendOptions backend;
    OutputOptions output;
    image::Metadata settings;  ///< the record of all settings; make_plan completes it
    image::Metadata given;     ///< settings that the user gave; an extraction must agree with them
};

/// The clock for a clip's ruler.
/// \throws Error usage when the requested source does not have the time
WallClock clock_of(const StartTime& start, const media::VideoInfo& info);

}  // namespace vvr::app
