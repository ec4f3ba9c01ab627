#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "core/base/text.h"

namespace vvr {

/// Serialises JSON. Bytes that are not UTF-8, as in file names, become U+FFFD. Characters that could disguise a name on
/// a terminal are escaped.
/// \param indent spaces per level; -1 = one line
/// \param ascii escape all non-ASCII characters
inline std::string json_text(const nlohmann::ordered_json& json, int indent = -1, bool ascii = false) {
    return shown_json(json.dump(indent, ' ', ascii, nlohmann::ordered_json::error_handler_t::replace));
}

/// Parses JSON. The result is discarded (`is_discarded`) if the text is not JSON or is nested so deeply that copying it
/// would exhaust the stack.
inline nlohmann::ordered_json parse_json(std::string_view text) {
    constexpr int max_depth = 64;
    bool too_deep = false;
    const auto check_depth = [&](int depth, nlohmann::ordered_json::parse_event_t, nlohmann::ordered_json&) {
        too_deep = too_deep || depth > max_depth;
        return !too_deep;
    };
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(text, check_depth, false);
    return too_deep ? nlohmann::ordered_json(nlohmann::ordered_json::value_t::discarded) : json;
}

}  // namespace vvr
