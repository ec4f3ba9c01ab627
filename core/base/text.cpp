#include "core/base/text.h"

#include <cstdint>

#include <fmt/format.h>

namespace vvr {

namespace {

bool continues(std::string_view text, std::size_t at) {
    return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80;
}

std::uint32_t code_of(std::string_view character) {
    const auto first = static_cast<unsigned char>(character[0]);
    std::uint32_t code = character.size() == 1 ? first : first & (0xFFU >> (character.size() + 1));
    for (const char c : character.substr(1)) code = code << 6 | (static_cast<unsigned char>(c) & 0x3FU);
    return code;
}

/// Whether a character shows nothing of its own, but changes how the text around it is shown.
bool is_hidden(std::uint32_t code) {
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x061C || code == 0x200E || code == 0x200F ||
           (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069) || code == 0xFEFF;
}

std::string escaped(std::uint32_t code) {
    switch (code) {
        case '\n':
            return "\\n";
        case '\r':
            return "\\r";
        case '\t':
            return "\\t";
        default:
            return code < 0x100 ? fmt::format("\\x{:02x}", code) : fmt::format("\\u{:04x}", code);
    }
}

std::string shown(std::string_view text, bool keeps_lines) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        if (length == 0) {
            result += escaped(static_cast<unsigned char>(text[0]));
            text.remove_prefix(1);
            continue;
        }
        const std::uint32_t code = code_of(text.substr(0, length));
        if (is_hidden(code) && !(keeps_lines && code == '\n')) {
            result += escaped(code);
        } else {
            result += text.substr(0, length);
        }
        text.remove_prefix(length);
    }
    return result;
}

}  // namespace

std::string shown_text(std::string_view text) {
    return shown(text, false);
}

std::string shown_lines(std::string_view text) {
    return shown(text, true);
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

std::size_t character_length(std::string_view text) {
    const auto first = static_cast<unsigned char>(text[0]);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xC2 && first < 0xE0 ? 2 : first >= 0xE0 && first < 0xF0 ? 3 : 4;
    if (first < 0xC2 || first > 0xF4) return 0;
    for (std::size_t k = 1; k < length; ++k) {
        if (!continues(text, k)) return 0;
    }
    const auto second = static_cast<unsigned char>(text[1]);
    // Overlong forms, halves of UTF-16 pairs, and values beyond the last character.
    const bool wrong = (first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0) ||
                       (first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90);
    return wrong ? 0 : length;
}

}  // namespace vvr
