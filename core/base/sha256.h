#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace vvr {

std::array<std::byte, 32> sha256(std::string_view bytes);

}  // namespace vvr
