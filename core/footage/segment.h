#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/wall_clock.h"

namespace vvr::footage {

/// One file of a recording.
struct Segment {
    std::string path;
    std::optional<std::int64_t> begin{};           ///< seconds since 1970 (UTC); none = it follows the previous segment
    ClockSource begin_source = ClockSource::none;  ///< source of `begin`
    std::string camera{};                          ///< empty = unknown
    std::string scheme{};                          ///< as RecorderName::scheme
    bool sub = false;                              ///< as RecorderName::sub
    bool no_clock = false;                         ///< as RecorderName::no_clock
    double slack = 1;  ///< seconds; a file that begins so near to the end of the one before follows it
};

}  // namespace vvr::footage
