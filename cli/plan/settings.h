#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cli/plan/look.h"
#include "cli/plan/options.h"
#include "core/base/setting.h"
#include "core/fields/options.h"
#include "core/fields/seeds.h"
#include "core/fields/settings.h"
#include "core/image/picture.h"
#include "core/media/frame_source.h"
#include "core/scene/theme.h"
#include "core/space/layout.h"
#include "gl/context.h"
#include "gl/render_options.h"

// The registry of settings. A setting is a row, and a line of the list below that visits it with the member of the job
// that holds its value. The type of that member decides how the value is parsed and printed (cli/options/value.h);
// the list decides the group in the help. The options of the commands and the checks of a job visit these lists.
// Settings of other groups are added in cli/options/job_options.cpp and output.cpp. The settings of fields are in
// core/fields/settings.h, those of video in core/media/settings.h.
namespace vvr::setting {

inline constexpr Setting events{
    .name = "events",
    .unit = "LIST",
    .help =
        "kinds of events that the picture numbers, and that report, tables and page list; a time leaves out shorter "
        "ones: moved,left,5s"};
inline constexpr Setting detector{
    .name = "detector",
    .unit = "MODEL",
    .help = "object detector that classifies events as person, car, ...: a YOLOX model in ONNX format (.onnx)",
    .may_be_file = true};

inline constexpr Setting step{
    "step", "FRAMES", "frames per layer of the volume; 0 = as few as the window allows", {0, 1'000'000}};

inline constexpr Setting layers{
    "layers",
    "COUNT",
    "maximum number of layers of the window; frames of a longer clip share layers; more take more memory",
    {2, 100'000}};

inline constexpr Setting brick{"brick", "TIME", "length of a brick; default in a series: 10s, less in a short clip"};
inline constexpr Setting window{
    "window",
    "COUNT",
    "number of bricks: one picture divides the clip into this many; each picture of a series shows this many",
    {1, 256}};
inline constexpr Setting time{.name = "time",
                              .unit = "NAME",
                              .help = "scale of time along the arc",
                              .not_live_reason = "the pictures of a stream share one scale of time"};

inline constexpr Setting layout{"layout", "NAME", "shape of the volume in space"};
inline constexpr Setting radius{"radius", "IN:OUT", "inner and outer radius of the horseshoe", {0.01, 100}};
inline constexpr Setting height{"height", "UNITS", "height of a frame; default: square pixels", {0.001, 100}};
inline constexpr Setting size{
    .name = "size",
    .unit = "WxH",
    .help =
        "width and height of the picture in pixels; the default is 1280x800 where there are no stills, as in a page",
    .range = {1, 16'384}};
inline constexpr Setting camera{"camera", "AZIMUTH,ELEVATION",
                                "direction of the camera: degrees to the right, degrees above the floor"};
inline constexpr Setting fov{"fov", "DEGREES", "vertical field of view; 0 = orthographic", {0, 150}};
inline constexpr Setting slices{
    "slices", "COUNT", "number of slices of the volume; auto = one per two voxels", {0, 16'384}};
inline constexpr Setting samples{
    "samples", "COUNT", "samples per pixel (antialiasing); OpenGL may support fewer", {1, 64}};

inline constexpr Setting show{"show", "LIST", "parts that are drawn"};
inline constexpr Setting keyframes{
    "keyframes", "COUNT", "number of frames shown between the first and the last; in a series, in each brick", {0, 32}};
inline constexpr Setting theme{"theme", "NAME", "colours of everything but the video"};
inline constexpr Setting background{
    .name = "background",
    .unit = "COLOR",
    .help = "colour of the background: #rrggbb, or none = transparent; default: the theme's"};
inline constexpr Setting title{"title", "TEXT", "title above the picture; default: the clip's name"};
inline constexpr Setting start_time{
    .name = "start-time",
    .unit = "DATETIME",
    .help =
        "time of day at which the clip begins: 2026-11-21 08:00:00; 'recorded' = the time in its name, in this "
        "machine's time zone; 'container' = the creation time in the container; 'modified' = the file's "
        "modification time, less its length; 'none' = times count from 0:00",
    .default_text = "recorded if the name has a time, else none",
    .not_live_reason = "a stream is not recorded; give the date and time"};
/// For a live stream.
inline constexpr Setting stream_clock{
    .name = "start-time",
    .unit = "DATETIME",
    .help = "time of day at which the stream begins: 2026-11-21 08:00:00; 'none' = times count from 0:00",
    .default_text = "now, by this machine's clock"};
inline constexpr Setting transfer{.name = "transfer",
                                  .unit = "NAME",
                                  .help = "colour and opacity of the volume's values",
                                  .default_text = "the theme's",
                                  .may_be_file = true};
inline constexpr Setting colour{"color", "NAME", "colour of the volume"};
inline constexpr Setting shading{"shading", "NAME", "shading of the volume"};
inline constexpr Setting opacity{"opacity", "FACTOR", "factor on the volume's opacity", {0, 1000}};
inline constexpr Setting glyph_scale{"glyph-scale", "FACTOR", "factor on the size of arrows", {0.01, 100}};
inline constexpr Setting trace_steps{"trace-steps", "COUNT", "number of steps of a traceline", {1, 100'000}};
inline constexpr Setting time_velocity{
    "time-velocity",
    "NUMBER",
    "the paper's v_t, frames moved along the arc per frame; 0 = arrows and tracelines stay in their frame",
    {-1000, 1000}};

inline constexpr Setting backend{"backend", "NAME", "OpenGL backend; egl:1 = its device 1 in the list of `vvr doctor`"};

inline constexpr Setting animate{
    "animate", "COUNT", "number of pictures; from one to the next, stripes move along the tracelines", {2, 10'000}};
inline constexpr Setting slide{
    "slide", "COUNT", "video of the window as it moves over the clip, with this many pictures per brick", {1, 1000}};
inline constexpr Setting bless{"bless", "", "replace the golden picture instead of comparing; writes no --diff"};
inline constexpr Setting tolerance{
    "tolerance", "FACTOR", "factor on the limits of the comparison; 0 = every sample must be the same", {0, 100}};

}  // namespace vvr::setting

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

/// A word for what no number says. It stands for 0, or for the size below it.
struct Word {
    std::string_view text;  ///< empty = 0 means that none is given
};

// The lists. Each calls `each` with the row and the member. Further arguments are, for the name of a row of a table,
// the table; for an enum, also the table's member of that type; for a number whose default depends on another setting,
// that setting, its table, and the default of a row; or a word.

template <class Bricks, class Each>
void each_brick_setting(Bricks& bricks, const Each& each) {
    each(setting::brick, bricks.length);
    each(setting::window, bricks.window);
    each(setting::layers, bricks.max_layers);
    each(setting::time, bricks.time, time_scales, &TimeScaleRow::scale);
}

template <class Job, class Each>
void each_view_setting(Job& job, const Each& each) {
    auto& picture = job.picture;
    each(setting::layout, job.layout, space::layouts());
    each(setting::fov, picture.view.fov);
    each(setting::samples, picture.samples);
    each(setting::radius, job.shape);
    each(setting::height, job.shape.height, Word{""});
    each(setting::size, picture.size);
    each(setting::camera, picture.view);
    each(setting::slices, picture.slices, Word{"auto"});
}

template <class Job, class Each>
void each_look_setting(Job& job, const Each& each) {
    auto& look = job.look;
    each(setting::show, look.show);
    each(setting::theme, look.theme, scene::themes());
    each(setting::background, look.background);
    each(setting::start_time, look.start_time);
    each(setting::transfer, look.transfer);
    each(setting::shading, job.picture.shading, gl::volume_shadings, &gl::VolumeShadingRow::shading);
    each(setting::keyframes, look.keyframes);
    each(setting::title, look.title);
    each(setting::colour, look.colour, colour_rows());
    each(setting::opacity, look.opacity);
    each(setting::glyph_scale, look.glyph_scale);
    each(setting::trace_steps, look.traces.steps);
    each(setting::time_velocity, look.traces.time_velocity);
}

/// \throws Error usage when a value is out of range or values contradict each other
void validate(const RenderJob& job);

/// \throws Error usage for settings that apply only to one picture of a whole clip
void validate_series(const RenderJob& job);

}  // namespace vvr::app
