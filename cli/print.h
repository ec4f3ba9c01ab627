#pragma once

#include <string_view>

namespace vvr::cli {

/// Writes `text`, data for the user, to stdout. A reader that has seen enough, as `head` has, is no error.
/// \throws Error io
void print(std::string_view text);

}  // namespace vvr::cli
