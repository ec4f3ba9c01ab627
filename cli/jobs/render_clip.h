#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/jobs/stages.h"
#include "core/events/event_choice.h"
#include "core/image/picture.h"
#include "core/labels/lettering.h"
#include "core/labels/time_ticks.h"
#include "core/scene/glyph.h"
#include "core/scene/theme.h"
#include "core/scene/traceline.h"
#include "core/store/field_source.h"
#include "gl/renderer.h"

namespace vvr {

/// The words that RenderJob::show takes.
const std::vector<std::string>& show_words();

/// Those of them that a picture has if nothing else is asked for.
const std::vector<std::string>& standard_show();

/// What the values of a volume are, for the legend.
struct ScalarMeaning {
    std::string name;
    std::string help;
};

/// Everything that decides how a clip becomes a picture.
struct RenderJob {
    std::int64_t max_layers = 800;  ///< of the window; a longer clip is sampled in time
    std::int64_t step = 0;          ///< frames a layer takes; 0 = as many as max_layers asks for
    int bricks = 8;                 ///< K, where brick_seconds and brick_frames are 0; of a series, k
    double brick_seconds = 0;
    std::int64_t brick_frames = 0;

    std::string layout = "horseshoe";
    double r_min = 0.45;
    double r_max = 1;
    double height = 0;  ///< y_s; 0 = square pixels

    bool find_events = false;  ///< makes sense where what isn't 0 in the scalar field is an object
    EventChoice events;        ///< of those that are found
    bool series = false;       ///< a picture for each brick, while a window of `bricks` of them slides over the clip
    bool layers = false;       ///< pictures come with what each of their pixels shows
    int pictures = 1;          ///< over which the tracelines' texture moves on by one stripe
    RenderOptions picture;     ///< ring and window_layers are found out
    TransferFunction transfer = default_transfer_function();
    double opacity = 1;  ///< factor on its extinctions
    GlyphOptions glyphs;
    TraceOptions traces;
    Theme theme = themes().front();
    std::string title;  ///< empty = the clip's name
    WallClock clock;    ///< when the clip begins
    ScalarMeaning scalar;
    int keyframes = 0;               ///< frames that stand in the volume between the first and the last
    std::optional<View> slice_view;  ///< for which the slices that `show` draws are cut; none = the picture's
    std::set<std::string> show = {standard_show().begin(), standard_show().end()};

    std::string backend = "auto";
    int device = -1;
};

/// What happened on the way.
struct RenderReport {
    VideoInfo info;
    Size field_size;
    std::int64_t frames = 0;  ///< that reached the volume
    std::int64_t damaged = 0;
    double first_pts = 0;  ///< seconds
    double last_pts = 0;
    std::int64_t first_frame = 0;  ///< index in the clip
    std::int64_t last_frame = 0;
    std::int64_t layers = 0;
    std::int64_t step = 1;      ///< frames a layer
    std::vector<Brick> bricks;  ///< in layers
    std::int64_t pictures = 1;  ///< so far
    std::size_t arrows = 0;
    bool still = false;           ///< nothing in the volume is visible
    bool frames_missing = false;  ///< frames that should stand in the picture came without one
    std::string renderer;         ///< GL_RENDERER
    std::string gl_version;       ///< GL_VERSION
    std::string backend;
    std::optional<std::vector<Event>> events;  ///< where they were looked for
    Lettering lettering;                       ///< on the last picture
    std::size_t keyframes = 0;                 ///< that stand between the first and the last frame
    Stages stages;
};

struct RenderedClip {
    Picture picture;
    RenderReport report;
};

/// Called now and then with the number of frames read.
using FrameProgress = std::function<void(std::int64_t)>;

/// The frames that each layer is to take, from what the container says of the clip's length.
std::int64_t planned_step(const RenderJob& job, std::int64_t frames);

/// The textures that there are at a time of so many pieces of bricks. In a single picture each is drawn but once: one
/// texture is filled while another is drawn.
int textures_of(const RenderJob& job, int pieces);

/// The main job: frames → fields → bricks → renderer → picture. The GL context is opened first: hours of video are not
/// to be read in vain.
RenderedClip render_clip(const RenderJob& job, FieldSource& source, const FrameProgress& progress);

/// Takes each picture of a job with its number from 0 on.
using PictureSink = std::function<void(const RenderReport& report, int number, Picture&& picture)>;

/// The same for all `job.pictures`: only the phase of the tracelines' texture changes from one to the next, and the
/// last is followed by the first.
RenderReport render_clip(const RenderJob& job, FieldSource& source, const FrameProgress& progress,
                         const PictureSink& sink);

}  // namespace vvr
