#pragma once

#include <string_view>

namespace vvr::video {

/// Whether `a` comes before `b` as people count: "frame2" before "frame10". Runs of digits compare by value, the rest
/// by bytes; names that differ only in leading zeros keep their byte order.
bool natural_less(std::string_view a, std::string_view b);

}  // namespace vvr::video
