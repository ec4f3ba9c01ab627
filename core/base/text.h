#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace vvr {

/// `1 frame`, `2 frames`.
inline std::string counted(std::int64_t count, const std::string& word) {
    return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

/// Rounds to three decimals: the accuracy of times and places in reports, pages and logs.
inline double rounded(double value) {
    return std::round(value * 1000) / 1000;
}

/// Whether this is an ASCII digit, in any locale.
constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Escapes untrusted text for terminals, logs and reports: control characters, bidirectional marks, line separators and
/// bytes that are not UTF-8 become escapes (`\n`, `\x1b`, `\u202e`). So text can't forge a line, move the cursor or
/// disguise a name.
std::string shown_text(std::string_view text);

/// Escapes the same characters of JSON, so that it can be shown on a terminal. Its value stays the same.
std::string shown_json(std::string_view json);

/// Removes private parts of every `scheme://...` address in a text: user and password, and everything from `?` or `#`
/// on.
std::string redact_secrets(std::string_view text);

/// A character decoded from UTF-8.
struct Character {
    char32_t code = 0;
    std::size_t length = 0;  ///< in bytes
};

/// The first character of a text; nothing if the text is empty or doesn't start with valid UTF-8.
std::optional<Character> first_character(std::string_view text);

}  // namespace vvr
