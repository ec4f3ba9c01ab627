#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace vvr {

/// JSON as text. Bytes that are not UTF-8, which file names may hold, become U+FFFD.
/// \param indent spaces per level; -1 = all in one line
/// \param ascii other characters are written as escapes
inline std::string json_text(const nlohmann::ordered_json& json, int indent = -1, bool ascii = false) {
    return json.dump(indent, ' ', ascii, nlohmann::ordered_json::error_handler_t::replace);
}

/// The value of a text; a discarded one (`is_discarded`) for what is no JSON, or is nested so deep that copying it
/// would exhaust the stack.
inline nlohmann::ordered_json parse_json(std::string_view text) {
    constexpr int deepest = 64;
    bool too_deep = false;
    const auto look = [&](int depth, nlohmann::ordered_json::parse_event_t, nlohmann::ordered_json&) {
        too_deep = too_deep || depth > deepest;
        return !too_deep;
    };
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(text, look, false);
    return too_deep ? nlohmann::ordered_json(nlohmann::ordered_json::value_t::discarded) : json;
}

}  // namespace vvr
