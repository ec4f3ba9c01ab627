#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace vvr {

/// JSON as text. Bytes that are not UTF-8, which file names may hold, become U+FFFD.
/// \param indent spaces per level; -1 = all in one line
/// \param ascii other characters are written as escapes
inline std::string json_text(const nlohmann::ordered_json& json, int indent = -1, bool ascii = false) {
    return json.dump(indent, ' ', ascii, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace vvr
