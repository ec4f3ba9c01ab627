#pragma once

#include <cstddef>
#include <cstdint>

// What can be in a file of an archive. Others may have written it, and one absurd number must not hold up the rest.
namespace vvr::archive {

inline constexpr std::int64_t last_time = 7'258'118'400;          ///< 2200-01-01, in seconds since 1970
inline constexpr double longest_recording = 10.0 * 366 * 86'400;  ///< seconds: no clip, and no day, is that long
inline constexpr std::size_t largest_sidecar = std::size_t{32} << 20;
inline constexpr std::size_t largest_report = std::size_t{256} << 20;

/// Whether a time in seconds since 1970 can be that of a recording: of 1970 to 2199.
constexpr bool can_be_time(std::int64_t seconds) {
    return seconds >= 0 && seconds < last_time;
}

}  // namespace vvr::archive
