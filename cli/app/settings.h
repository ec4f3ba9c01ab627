#pragma once

#include "cli/app/colour.h"
#include "core/base/setting.h"
#include "core/fields/settings.h"
#include "core/space/layout.h"

/// The settings of a RenderJob, except those of its fields.
namespace vvr::setting {

inline constexpr Setting step{
    "step", "FRAMES", "frames per layer of the volume; 0 = as few as the window allows", {0, 1'000'000}};

inline constexpr Setting layers{
    "layers",
    "COUNT",
    "maximum number of layers of the window; frames of a longer clip share layers; more take more memory",
    {2, 100'000}};

inline constexpr Setting brick{"brick", "TIME",
                               "length of a brick; in a series 10s if not given, less in a short clip"};
inline constexpr Setting window{
    "window", "COUNT", "bricks shown: one picture divides the clip into this many, a series moves on by one", {1, 256}};
inline constexpr Setting time{.name = "time",
                              .unit = "NAME",
                              .help = "scale of time along the arc",
                              .not_live_reason = "the pictures of a stream share one scale of time"};

inline constexpr Setting layout{"layout", "NAME", "shape of the volume in space"};
inline constexpr Setting radius{"radius", "IN:OUT", "inner and outer radius of the horseshoe", {0.01, 100}};
inline constexpr Setting height{"height", "UNITS", "height of a frame; square pixels if not given", {0.001, 100}};
inline constexpr Setting size{
    .name = "size", .unit = "WxH", .help = "width and height of the picture in pixels", .range = {1, 16'384}};
inline constexpr Setting camera{
    "camera", "AZIMUTH,ELEVATION",
    "direction from which the picture is seen: degrees to the right, degrees above the floor"};
inline constexpr Setting slice_view{
    "slice-view", "AZIMUTH,ELEVATION",
    "direction of the view whose slices the part slices shows; the picture's own if not given"};
inline constexpr Setting fov{"fov", "DEGREES", "vertical field of view; 0 = orthographic", {0, 150}};
inline constexpr Setting slices{
    "slices", "COUNT", "slices of the volume; auto or 0 = one per two voxels", {0, 16'384}, "auto"};
inline constexpr Setting samples{
    "samples", "COUNT", "samples per pixel (antialiasing); OpenGL may support fewer", {1, 64}};

inline constexpr Setting show{"show", "LIST", "parts that are drawn"};
inline constexpr Setting keyframes{
    "keyframes", "COUNT", "frames shown between the first and the last; in a series, in each brick", {0, 32}};
inline constexpr Setting theme{"theme", "NAME", "colours of everything but the video"};
inline constexpr Setting background{
    .name = "background", .unit = "COLOR", .help = "#rrggbb, or none = transparent; the theme's if not given"};
inline constexpr Setting title{"title", "TEXT", "title above the picture; the clip's name if not given"};
inline constexpr Setting font{.name = "font",
                              .unit = "FILE",
                              .help = "font of all text: .ttf, .otf; fontconfig's sans if not given",
                              .may_be_file = true};
inline constexpr Setting start_time{.name = "start-time",
                                    .unit = "DATETIME",
                                    .help =
                                        "what a clock showed when the clip began: 2026-11-21 08:00:00; 'recorded' = "
                                        "as its name says, in this machine's time zone; 'container' = when its "
                                        "container says it was written; 'modified' = when the file was last written, "
                                        "less its length; 'none' = times run from 0:00",
                                    .default_text = "recorded where its name tells it, else none",
                                    .not_live_reason = "a stream is not recorded; give the date and time"};
/// For a live stream.
inline constexpr Setting stream_clock{.name = "start-time",
                                      .unit = "DATETIME",
                                      .help =
                                          "what a clock shows when the stream begins: 2026-11-21 08:00:00; 'none' = "
                                          "times run from 0:00",
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
inline constexpr Setting glyph_cap{
    "glyph-cap", "UNITS", "longest arrow; faster ones have this length and a redder colour", {0.001, 10}};
inline constexpr Setting trace_steps{"trace-steps", "COUNT", "number of steps of a traceline", {1, 100'000}};
inline constexpr Setting trace_dt{"trace-dt", "FRAMES", "time step of a traceline", {1e-3, 1000}};
inline constexpr Setting trace_rest{"trace-rest",
                                    "PIXELS",
                                    "a traceline ends where flow is slower than this, in pixels per frame; 0 = never",
                                    {0, 10'000}};
inline constexpr Setting time_velocity{
    "time-velocity",
    "NUMBER",
    "the paper's v_t, frames moved along the arc per frame; 0 = arrows and tracelines stay in their frame",
    {-1000, 1000}};

inline constexpr Setting backend{"backend", "NAME", "OpenGL backend"};
inline constexpr Setting gl_debug{"gl-debug", "", "log all messages of the OpenGL driver; slower"};
inline constexpr Setting device{
    "device", "NUMBER", "EGL device as `vvr doctor` numbers them; -1 = the first that works", {-1, 255}};

inline constexpr Setting animate{
    "animate", "COUNT", "number of pictures in which stripes run along the tracelines", {2, 10'000}};
inline constexpr Setting slide{
    "slide", "COUNT", "film of the window that slides over the clip, with this many pictures per brick", {1, 1000}};
inline constexpr Setting tolerance{
    "tolerance", "LEVEL", "largest difference of a channel at which pixels count as equal", {0, 1}};
inline constexpr Setting tolerance_percent{
    "tolerance-percent", "PERCENT", "share of the pixels that may differ by more", {0, 100}};
inline constexpr Setting tolerance_patch{
    "tolerance-patch", "LEVEL", "largest mean difference of any small patch", {0, 1}};

}  // namespace vvr::setting

namespace vvr::app {

/// Calls `each` for the settings of a RenderJob whose whole value is one number, name, text or file, with the member
/// that holds the value and, for a name, the table of rows. The command line and the range checks use these lists.
template <class Job, class Each>
void each_brick_setting(Job& job, const Each& each) {
    each(setting::window, job.bricks.window);
    each(setting::layers, job.bricks.max_layers);
}

template <class Job, class Each>
void each_view_setting(Job& job, const Each& each) {
    each(setting::layout, job.layout, space::layouts());
    each(setting::fov, job.picture.view.fov);
    each(setting::samples, job.picture.samples);
}

template <class Job, class Each>
void each_look_setting(Job& job, const Each& each) {
    auto& look = job.look;
    each(setting::keyframes, look.keyframes);
    each(setting::title, look.title);
    each(setting::font, look.font);
    each(setting::colour, look.colour, colour_rows());
    each(setting::opacity, look.opacity);
    each(setting::glyph_scale, look.glyph_scale);
    each(setting::glyph_cap, look.glyph_cap);
    each(setting::trace_steps, look.traces.steps);
    each(setting::trace_dt, look.traces.dt);
    each(setting::trace_rest, look.traces.rest);
    each(setting::time_velocity, look.traces.time_velocity);
}

}  // namespace vvr::app
