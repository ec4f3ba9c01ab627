#pragma once

#include <functional>
#include <string>

#include <nlohmann/json_fwd.hpp>

// The events of reports as a table with commas, for spreadsheets, R and pandas (`--events-csv`).
namespace vvr::tracking {

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
