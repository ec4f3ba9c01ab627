#pragma once

#include "core/setting.h"

/// The settings of SourceOptions, FrameSpan and LiveOptions.
namespace vvr::setting {

inline constexpr Setting field_size{"field-size", "WxH", "size of the fields, or 'source'; long side 384 if not given"};
inline constexpr Setting rate{"rate", "FPS", "frames per second of pictures and raw streams", {0.001, 100'000}};
inline constexpr Setting names{"names", "PATTERN",
                               "how files' names tell camera and time, as '%Y-%m-%d/%H/{camera}/%M.%S'; can be given "
                               "several times; known besides: "};
inline constexpr Setting start{"start", "TIME", "first frame: 250, 12.5s or 00:00:12.5", {}, "0"};
inline constexpr Setting end{"end", "TIME", "the first frame that is no longer read"};

inline constexpr Setting duration{"duration", "TIME",
                                  "stop after 90s, 10m, 2h or 1d; without it, SIGTERM or SIGINT stops"};
inline constexpr Setting lag{
    "lag", "SECONDS", "drop frames that have waited longer for their turn; pipes wait instead", {0.1, 60}};
inline constexpr Setting patience{"patience", "SECONDS", "reconnect when no frame has come for this long", {0.5, 3600}};

}  // namespace vvr::setting
