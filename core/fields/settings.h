#pragma once

#include "core/base/setting.h"
#include "core/video/settings.h"

/// The settings of FieldOptions.
namespace vvr::setting {

inline constexpr Setting filter{"filter", "NAME", "what counts as interesting"};
inline constexpr Setting reference{.name = "reference", .unit = "NAME", .help = "the empty scene", .may_be_file = true};
inline constexpr Setting threshold{"threshold",
                                   "GREY",
                                   "smaller differences count as none; the default is that of --filter",
                                   {0, 255},
                                   "the filter's"};
inline constexpr Setting norm{"norm", "NAME", "by what frames are said to differ"};
inline constexpr Setting smooth{"smooth", "PIXELS", "Gaussian smoothing before a comparison", {0, 20}};
inline constexpr Setting min_area{"min-area", "PIXELS", "blobs of fewer field pixels are noise", {0, 1'000'000}};
inline constexpr Setting illumination{"illumination", "NAME", "changes of light that don't count"};
inline constexpr Setting shadows{"shadows", "NAME", "cast shadows"};
inline constexpr Setting stabilize{"stabilize", "NAME", "a camera that shakes"};
inline constexpr Setting roi{.name = "roi", .unit = "AREA", .help = "look only here", .may_be_file = true};
inline constexpr Setting mask{.name = "mask",
                              .unit = "AREA",
                              .help = "don't look here, for example at the camera's burnt-in clock",
                              .may_be_file = true};

inline constexpr Setting flow{"flow", "NAME", "optical flow"};
inline constexpr Setting flow_area{"flow-area", "NAME", "where flow is computed"};
inline constexpr Setting flow_every{
    "flow-every", "FRAMES", "keep flow and seeds of frames whose number is a multiple of this", {1, 1e9}};
inline constexpr Setting solver{"solver", "NAME", "solver of horn-schunck"};
inline constexpr Setting derivatives{"derivatives", "NAME",
                                     "derivatives of horn-schunck; the solver pyramid has its own"};
/// Less than this and float can't hold α² beside the squares of the derivatives.
inline constexpr Setting alpha{"alpha",
                               "NUMBER",
                               "weight of smooth flow; its square is the paper's λ; by --solver",
                               {0.01, 10'000},
                               "the solver's"};
inline constexpr Setting iterations{
    "iterations", "COUNT", "the solver's warps (pyramid) or steps (jacobi)", {1, 100'000}, "the solver's"};
inline constexpr Setting pre_smooth{
    "pre-smooth", "PIXELS", "Gaussian smoothing before derivatives; by --solver", {0, 5}, "the solver's"};

inline constexpr Setting grid{"grid", "PIXELS", "distance between neighbouring seeds", {1, 10'000}};
inline constexpr Setting min_magnitude{
    "min-magnitude", "PIXELS", "no seeds where flow is slower than this, in pixels per frame", {0, 10'000}};
inline constexpr Setting seed_area{"seed-area", "NAME", "where seeds may lie"};
inline constexpr Setting seed_order{"seed-order", "NAME", "which seeds come first"};
inline constexpr Setting seed_select{"seed-select", "HOW",
                                     "which seeds of a frame are kept: all, first:N or random:N[:NUMBER]"};
inline constexpr Setting seeds{.name = "seeds",
                               .unit = "PATH",
                               .help =
                                   "read seeds instead of computing them: a folder with a list for each frame, as "
                                   "`vvr extract` writes it, or one list that all frames share",
                               .may_be_file = true};
inline constexpr Setting seed_flags{
    .name = "seed-flags",
    .unit = "DIGITS",
    .help = "bricks whose seeds are drawn: a digit 0 or 1 per brick, in turn; 100 = each third brick",
    .default_text = "the seeds' own"};

inline constexpr Setting threads{
    "threads", "COUNT", "threads; 0 = one per core, which the clips of an archive share", {0, 1024}};

}  // namespace vvr::setting
