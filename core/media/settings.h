#pragma once

#include "core/base/setting.h"

/// The settings of SourceOptions, FrameSpan and LiveOptions.
namespace vvr::setting {

inline constexpr Setting field_size{"field-size", "WxH",
                                    "size of the fields, or 'source' for the video's own size; default: long side 384"};
inline constexpr Setting rate{.name = "rate",
                              .unit = "FPS",
                              .help =
                                  "frames per second, in place of those that the file states; 1/24s is a frame every "
                                  "24 s, as in a time-lapse",
                              .range = {0.0001, 100'000},
                              .default_text = "as stated, or 25"};
inline constexpr Setting track{.name = "track",
                               .unit = "NUMBER",
                               .help = "which video track of a file with several, counted from 1",
                               .range = {1, 1000},
                               .default_text = "the best one",
                               .not_live_reason = "a stream has one video track"};
inline constexpr Setting aspect{
    .name = "aspect",
    .unit = "W:H",
    .help =
        "shape of the picture, such as 16:9, in place of the one that the video states; for "
        "recorders that store half of the width (1080N)"};
inline constexpr Setting decode{
    .name = "decode",
    .unit = "NAME",
    .help =
        "the frames of a video file that are decoded; fewer take less time; frame numbers count only "
        "decoded frames",
    .not_live_reason = "every frame of a stream is decoded"};
inline constexpr Setting hwaccel{
    "hwaccel", "NAME",
    "what decodes the video; a video that the hardware can't decode is decoded by the processor, and the log says so"};
inline constexpr Setting names{"names", "PATTERN",
                               "pattern of file names that give camera and time, such as "
                               "'%Y-%m-%d/%H/{camera}/%M.%S'; can be given several times; built in: "};
inline constexpr Setting join{"join", "",
                              "treat the files as one recording, even if they seem unrelated or from several cameras"};
inline constexpr Setting start{
    .name = "start",
    .unit = "TIME",
    .help =
        "where in the clip to begin: 90s, 1h30m, 00:01:30, 250f; or a wall-clock time, if the clip's is known: "
        "2026-11-22 02:00, or @02:00 for the next 02:00",
    .default_text = "0s",
    .not_live_reason = "a stream begins now"};
inline constexpr Setting end{.name = "end",
                             .unit = "TIME",
                             .help = "where in the clip to end, in the same forms; the frame at this time is not read",
                             .not_live_reason = "--duration ends a stream"};

inline constexpr Setting between{.name = "between",
                                 .unit = "TIME-TIME",
                                 .help =
                                     "only this part of each day, in wall-clock time: 02:00-05:00, or across midnight: "
                                     "22:00-05:00",
                                 .not_live_reason = "a stream is drawn as it arrives"};

inline constexpr Setting duration{"duration", "TIME", "stop after this time; default: stop on SIGTERM or SIGINT"};
inline constexpr Setting patience{"patience", "TIME", "reconnect if no frame arrives for this long", {0.5, 3600}};

}  // namespace vvr::setting
