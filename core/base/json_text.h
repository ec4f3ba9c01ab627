#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "core/base/plane.h"
#include "core/base/text.h"

namespace vvr {

using Json = nlohmann::ordered_json;

/// Null for an empty text.
inline Json or_null(std::string_view text) {
    return text.empty() ? Json() : Json(text);
}

/// Null for nothing.
template <class Value>
Json or_null(const std::optional<Value>& value) {
    return value ? Json(*value) : Json();
}

/// A list of what `json_of` makes of each element.
template <class List, class JsonOf>
Json list_of(const List& list, const JsonOf& json_of) {
    Json json = Json::array();
    for (const auto& element : list) json.push_back(json_of(element));
    return json;
}

/// An object of names and texts, such as settings.
template <class Pairs>
Json object_of(const Pairs& pairs) {
    Json json = Json::object();
    for (const auto& [name, value] : pairs) json[std::string(name)] = value;
    return json;
}

inline Json json_of_box(const PixelBox& box) {
    return {{"x", box.left}, {"y", box.top}, {"width", box.width()}, {"height", box.height()}};
}

/// Serialises JSON. Bytes that are not UTF-8, as in file names, become U+FFFD. Characters that could disguise a name on
/// a terminal are escaped.
/// \param indent spaces per level; -1 = one line
/// \param ascii escape all non-ASCII characters
inline std::string json_text(const Json& json, int indent = -1, bool ascii = false) {
    return shown_json(json.dump(indent, ' ', ascii, Json::error_handler_t::replace));
}

/// Parses JSON. The result is discarded (`is_discarded`) if the text is not JSON or is nested so deeply that copying it
/// would exhaust the stack.
inline Json parse_json(std::string_view text) {
    constexpr int max_depth = 64;
    bool too_deep = false;
    const auto check_depth = [&](int depth, Json::parse_event_t, Json&) {
        too_deep = too_deep || depth > max_depth;
        return !too_deep;
    };
    Json json = Json::parse(text, check_depth, false);
    return too_deep ? Json(Json::value_t::discarded) : json;
}

}  // namespace vvr
