#pragma once

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

/// Text as a terminal, a log or a report may show it, whoever wrote it: control characters, marks that turn the
/// direction of writing, line separators and bytes that are not UTF-8 become escapes (`\n`, `\x1b`, `\u202e`). So
/// nothing forges a line, moves the cursor, or shows a name as another.
std::string shown_text(std::string_view text);

/// Text without what an address may hold that is nobody's business: user and password, and all from `?` or `#` on, of
/// every `scheme://...` in it.
std::string redact_secrets(std::string_view text);

/// A character of UTF-8.
struct Character {
    char32_t code = 0;
    std::size_t length = 0;  ///< in bytes
};

/// The character at the front of a text; nothing where the text is empty or begins with bytes that are not UTF-8.
std::optional<Character> first_character(std::string_view text);

}  // namespace vvr
