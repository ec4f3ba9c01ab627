#pragma once

#include "core/setting.h"

/// The settings of SourceOptions, FrameSpan and LiveOptions.
namespace vvr::setting {

inline constexpr Setting field_size{"field-size", "WxH", "size of the fields, or 'source'; long side 384 if not given"};
inline constexpr Setting rate{.name = "rate",
                              .unit = "FPS",
                              .help = "frames per second of pictures and raw streams",
                              .range = {0.001, 100'000},
                              .alias = "frame-rate"};
inline constexpr Setting names{"names", "PATTERN",
                               "how files' names tell camera and time, as '%Y-%m-%d/%H/{camera}/%M.%S'; can be given "
                               "several times; known besides: "};
inline constexpr Setting start{.name = "start",
                               .unit = "TIME",
                               .help = "where in the clip to begin: the first frame that is read",
                               .otherwise = "0s",
                               .not_live = "a stream begins now"};
inline constexpr Setting end{.name = "end",
                             .unit = "TIME",
                             .help = "where in the clip to end: the first frame that is no longer read",
                             .not_live = "--duration ends a stream"};

inline constexpr Setting duration{"duration", "TIME", "stop after this time; without it, SIGTERM or SIGINT stops"};
inline constexpr Setting lag{
    "lag", "TIME", "drop frames that have waited longer for their turn; pipes wait instead", {0.1, 60}};
inline constexpr Setting patience{"patience", "TIME", "reconnect when no frame has come for this long", {0.5, 3600}};

}  // namespace vvr::setting
