#include "core/base/text.h"

#include <algorithm>

extern "C" {
#include <libavutil/avstring.h>
}

namespace vvr {

namespace {

/// Whether a character is invisible but affects how the text around it is shown.
bool is_hidden(char32_t code) {
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x061C || code == 0x200E || code == 0x200F ||
           (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069) || code == 0xFEFF;
}

std::string escaped(char32_t code) {
    switch (code) {
        case '\n':
            return "\\n";
        case '\r':
            return "\\r";
        case '\t':
            return "\\t";
        default:
            const auto number = static_cast<std::uint32_t>(code);
            return code < 0x100 ? fmt::format("\\x{:02x}", number) : fmt::format("\\u{:04x}", number);
    }
}

}  // namespace

std::string shown_text(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::optional<Character> character = first_character(text);
        const std::size_t length = character ? character->length : 1;
        if (!character) {
            result += escaped(static_cast<unsigned char>(text[0]));
        } else if (is_hidden(character->code)) {
            result += escaped(character->code);
        } else {
            result += text.substr(0, length);
        }
        text.remove_prefix(length);
    }
    return result;
}

std::string shown_json(std::string_view json) {
    std::string result;
    result.reserve(json.size());
    while (!json.empty()) {
        // JSON has escapes already for control characters of ASCII, except for DEL.
        const auto other = std::ranges::find_if(json, [](unsigned char byte) { return byte >= 0x7F; });
        result.append(json.begin(), other);
        json.remove_prefix(static_cast<std::size_t>(other - json.begin()));
        if (json.empty()) break;
        const std::optional<Character> character = first_character(json);
        const std::size_t length = character ? character->length : 1;
        if (character && is_hidden(character->code)) {
            result += fmt::format("\\u{:04x}", static_cast<std::uint32_t>(character->code));
        } else {
            result += json.substr(0, length);
        }
        json.remove_prefix(length);
    }
    return result;
}

std::string redact_secrets(std::string_view text) {
    constexpr std::string_view mark = "://";
    constexpr std::string_view address_ends = " \t\r\n'\"<>";
    std::string result;
    for (std::size_t at = text.find(mark); at != std::string_view::npos; at = text.find(mark)) {
        result += text.substr(0, at + mark.size());
        text.remove_prefix(at + mark.size());
        std::string_view address = text.substr(0, text.find_first_of(address_ends));
        text.remove_prefix(address.size());
        address = address.substr(0, address.find_first_of("?#"));
        const std::string_view host = address.substr(0, address.find('/'));
        if (const auto user = host.rfind('@'); user != std::string_view::npos) address.remove_prefix(user + 1);
        result += address;
    }
    return result.append(text);
}

std::optional<Character> first_character(std::string_view text) {
    const auto* const begin = reinterpret_cast<const std::uint8_t*>(text.data());
    const std::uint8_t* end = begin;
    std::int32_t code = 0;
    // U+FFFE and U+FFFF are noncharacters, but valid UTF-8.
    const int flags = AV_UTF8_FLAG_ACCEPT_NON_CHARACTERS;
    if (text.empty() || av_utf8_decode(&code, &end, begin + text.size(), flags) < 0) return std::nullopt;
    return Character{static_cast<char32_t>(code), static_cast<std::size_t>(end - begin)};
}

}  // namespace vvr
