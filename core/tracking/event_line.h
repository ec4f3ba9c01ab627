#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "core/base/plane.h"
#include "core/detector/classes.h"
#include "core/tracking/event.h"

// What other programs learn of an event when it has ended: one line of JSON.
namespace vvr::tracking {

/// The name of the heading of an object; empty for a thing that was left or taken, and where nothing is known.
std::string_view direction_of(const Event& event);

/// One event that has ended, or an interval in which the recording was at fault.
struct EventLine {
    std::string camera{};                         ///< empty = unknown
    std::string clip{};                           ///< the file or the stream
    std::size_t number = 0;                       ///< in the picture, the page and the report; 0 = it is no event
    std::string_view kind{};                      ///< of the event or of the recording's condition
    const detector::ObjectClass* what = nullptr;  ///< null = unknown
    double first = 0;                             ///< seconds of the clip
    double last = 0;
    std::optional<std::string> begin{};  ///< local time, ISO 8601; none = the recording time is unknown
    std::optional<std::string> end{};
    bool open_ended = false;       ///< as in Event
    PixelBox box{};                ///< of all its places, pixels of the video; empty = it is no event
    std::string_view direction{};  ///< from `direction_of`
    std::string page{};            ///< relative URL, which shows the event; empty = no page
};

/// The line, with its newline: an object whose values are texts, numbers, null and the box.
std::string format_event_line(const EventLine& line);

// The events of reports as a table with commas, for spreadsheets, R and pandas (`--events-csv`).

/// Where the events of a report belong.
struct TableClip {
    std::string camera{};  ///< empty = unknown
    std::string clip{};    ///< the clip, or the recording
    std::function<std::string(const std::string&)>
        file_of{};  ///< the name of a file that the report names; none = as it is
};

/// The first line of the table.
std::string events_table_heading();

/// A line for each event of a report (`vvr render --report`), and for each interval in which the recording was at
/// fault. Places are in pixels of the video. \throws nlohmann::json::exception for an invalid report
std::string events_table_lines(const nlohmann::ordered_json& report, const TableClip& place);

/// The line of a clip without events.
/// \param file empty = it has several
std::string empty_table_line(const TableClip& place, const std::string& file);

}  // namespace vvr::tracking
