#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/plane.h"
#include "core/detector/classes.h"
#include "core/events/event.h"
#include "core/events/event_kind.h"

// What other programs learn of an event when it has ended: one line of JSON.
namespace vvr::events {

/// The names of the eight directions in the frame, clockwise from the right, as in `heading_of`.
inline constexpr std::array<std::string_view, 8> heading_names{"right", "down-right", "down", "down-left",
                                                               "left",  "up-left",    "up",   "up-right"};

/// For an object that ended near where it began.
inline constexpr std::string_view to_and_fro = "to and fro";

/// Where an object went, one of the names above; empty for a thing that was left or taken, and where nothing is known.
std::string_view direction_of(const Event& event);

/// Whether a text is one of the names above.
bool is_direction(std::string_view text);

/// One event that has ended.
struct EventLine {
    std::string camera{};    ///< empty = unknown
    std::string clip{};      ///< the file or the stream
    std::size_t number = 0;  ///< in the picture, the page and the report
    EventKind kind = EventKind::moved;
    const detector::ObjectClass* what = nullptr;  ///< null = unknown
    double first = 0;                             ///< seconds of the clip
    double last = 0;
    std::optional<std::string> begin{};  ///< local time, ISO 8601; none = the recording time is unknown
    std::optional<std::string> end{};
    PixelBox box{};                ///< of all its places, pixels of the video
    std::string_view direction{};  ///< from `direction_of`
    std::string page{};            ///< relative URL, which shows the event; empty = no page
};

/// The line, with its newline: an object whose values are texts, numbers, null and the box.
std::string format_event_line(const EventLine& line);

}  // namespace vvr::events
