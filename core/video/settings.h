#pragma once

#include "core/base/setting.h"

/// The settings of SourceOptions, FrameSpan and LiveOptions.
namespace vvr::setting {

inline constexpr Setting field_size{"field-size", "WxH", "size of the fields, or 'source'; long side 384 if not given"};
inline constexpr Setting rate{
    .name = "rate", .unit = "FPS", .help = "frames per second of pictures and raw streams", .range = {0.001, 100'000}};
inline constexpr Setting names{"names", "PATTERN",
                               "how files' names tell camera and time, as '%Y-%m-%d/%H/{camera}/%M.%S'; can be given "
                               "several times; known besides: "};
inline constexpr Setting join{
    "join", "", "treat the files as one recording, even where they seem to be of several cameras, or unrelated"};
inline constexpr Setting start{
    .name = "start",
    .unit = "TIME",
    .help =
        "where in the clip to begin: 90s, 1h30m, 00:01:30, 250f; or by the clock on the wall, where that is known: "
        "2026-11-22 02:00, or @02:00 for the next time that it showed 02:00",
    .default_text = "0s",
    .not_live_reason = "a stream begins now"};
inline constexpr Setting end{
    .name = "end",
    .unit = "TIME",
    .help = "where in the clip to end, in the same forms: the first frame that is no longer read",
    .not_live_reason = "--duration ends a stream"};

inline constexpr Setting between{.name = "between",
                                 .unit = "TIME-TIME",
                                 .help =
                                     "only this part of each day, by the clock on the wall: 02:00-05:00; over "
                                     "midnight: 22:00-05:00",
                                 .not_live_reason = "a stream is drawn as it comes"};

inline constexpr Setting duration{"duration", "TIME", "stop after this time; without it, SIGTERM or SIGINT stops"};
inline constexpr Setting lag{
    "lag", "TIME", "drop frames that have waited longer than this to be processed; pipes wait instead", {0.1, 60}};
inline constexpr Setting patience{"patience", "TIME", "reconnect when no frame has come for this long", {0.5, 3600}};

}  // namespace vvr::setting
