#pragma once

#include "core/base/setting.h"
#include "core/fields/settings.h"

/// The settings of a RenderJob beside those of its fields.
namespace vvr::setting {

inline constexpr Setting step{
    "step", "FRAMES", "frames per layer of the volume; 0 = as few as the window allows", {0, 1'000'000}};

inline constexpr Setting layers{
    "layers",
    "COUNT",
    "layers of the window at most; frames of a longer clip share layers; memory grows with it",
    {2, 100'000}};

inline constexpr Setting brick{"brick", "TIME",
                               "length of a brick; in a series 10s if not given, less in a short clip"};
inline constexpr Setting window{"window",
                                "COUNT",
                                "bricks shown: one picture cuts the clip into this many, a series moves by one of them",
                                {1, 256}};
inline constexpr Setting time{.name = "time",
                              .unit = "NAME",
                              .help = "how the room along the arc is given to time",
                              .not_live_reason = "the pictures of a stream share one scale of time"};

inline constexpr Setting layout{"layout", "NAME", "how the volume lies in space"};
inline constexpr Setting radius{"radius", "IN:OUT", "inner and outer radius of the horseshoe", {0.01, 100}};
inline constexpr Setting height{"height", "UNITS", "height of a frame; square pixels if not given", {0.001, 100}};
inline constexpr Setting size{
    .name = "size", .unit = "WxH", .help = "pixels of the picture", .range = {1, 16'384}, .alias = "resolution"};
inline constexpr Setting camera{"camera", "AZIMUTH,ELEVATION",
                                "where the viewer of the picture is: degrees to the right and above the floor"};
inline constexpr Setting slice_view{"slice-view", "AZIMUTH,ELEVATION",
                                    "viewer whose slices are shown by the part slices; the picture's own if not given"};
inline constexpr Setting fov{"fov", "DEGREES", "vertical field of view; 0 = orthographic", {0, 150}};
inline constexpr Setting slices{
    "slices", "COUNT", "slices of the volume; auto or 0 = one per two voxels", {0, 16'384}, "auto"};
inline constexpr Setting samples{
    "samples", "COUNT", "samples per pixel, for smooth edges; OpenGL may support fewer", {1, 64}};

inline constexpr Setting show{"show", "LIST", "what is drawn"};
inline constexpr Setting keyframes{
    "keyframes", "COUNT", "frames shown between the first and the last; in a series, in each brick", {0, 32}};
inline constexpr Setting theme{"theme", "NAME", "colours of everything but the video"};
inline constexpr Setting background{.name = "background",
                                    .unit = "COLOR",
                                    .help = "#rrggbb, or none = transparent; the theme's if not given",
                                    .alias = "background-color"};
inline constexpr Setting title{"title", "TEXT", "above the picture; the clip's name if not given"};
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
/// Of a live stream.
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
                                  .may_be_file = true,
                                  .alias = "colormap"};
inline constexpr Setting colour{"color", "NAME", "colour of the volume"};
inline constexpr Setting shading{"shading", "NAME", "light on the volume"};
inline constexpr Setting opacity{"opacity", "FACTOR", "factor on the volume's opacity", {0, 1000}};
inline constexpr Setting glyph_scale{"glyph-scale", "FACTOR", "factor on the arrows' size", {0.01, 100}};
inline constexpr Setting glyph_cap{
    "glyph-cap", "UNITS", "longest arrow; the outer radius is 1. A faster one is as long and redder", {0.001, 10}};
inline constexpr Setting trace_steps{"trace-steps", "COUNT", "steps of a traceline", {1, 100'000}};
inline constexpr Setting trace_dt{"trace-dt", "FRAMES", "length of a traceline's step in time", {1e-3, 1000}};
inline constexpr Setting trace_rest{
    "trace-rest", "PIXELS", "a traceline ends where flow is slower, in pixels per frame; 0 = it goes on", {0, 10'000}};
inline constexpr Setting time_velocity{
    "time-velocity",
    "NUMBER",
    "the paper's v_t, frames moved along the arc per frame; 0 = arrows and tracelines stay in their frame",
    {-1000, 1000}};

inline constexpr Setting backend{"backend", "NAME", "which OpenGL draws"};
inline constexpr Setting gl_debug{"gl-debug", "", "warn of all that the OpenGL driver reports; slower"};
inline constexpr Setting device{
    "device", "NUMBER", "EGL device as `vvr doctor` numbers them; -1 = the first that works", {-1, 255}};

inline constexpr Setting animate{"animate", "COUNT", "pictures in which stripes run along the tracelines", {2, 10'000}};
inline constexpr Setting slide{
    "slide", "COUNT", "a film of the window that slides over the clip: so many pictures per brick", {1, 1000}};
inline constexpr Setting tolerance{"tolerance", "LEVEL", "a pixel is off if a channel differs by more", {0, 1}};
inline constexpr Setting tolerance_percent{
    "tolerance-percent", "PERCENT", "share of the pixels that may be off", {0, 100}};
inline constexpr Setting tolerance_patch{
    "tolerance-patch", "LEVEL", "mean difference that any small patch may have", {0, 1}};

}  // namespace vvr::setting
