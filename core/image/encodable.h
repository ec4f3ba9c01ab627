#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/image/picture.h"

namespace vvr {

/// How a channel's values stand in a file.
enum class Stored { uint8, uint16, half };

/// A picture file that is to be encoded.
struct Encodable {
    std::string format;  ///< its ending, without the dot
    std::string name;    ///< for what the library says of it
    Size size;
    int colours = 3;  ///< channels
    Stored stored = Stored::uint8;
    std::vector<std::string> layers{};  ///< names of further channels of floats
    Metadata attributes{};
    std::variant<std::span<const float>, std::span<const std::uint8_t>> values{};
};

}  // namespace vvr
