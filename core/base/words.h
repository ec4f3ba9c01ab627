#pragma once

#include <cstdint>
#include <string>

#include <fmt/format.h>

namespace vvr {

/// `1 frame`, `2 frames`.
inline std::string counted(std::int64_t count, const std::string& word) {
    return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

}  // namespace vvr
