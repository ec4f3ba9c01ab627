#include "core/page/html.h"

#include <algorithm>
#include <stdexcept>

#include <zlib.h>

#include <fmt/format.h>

#include "core/base/digest.h"
#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/tracking/event_kind.h"

extern "C" {
#include <libavutil/base64.h>
}

namespace vvr::page {

namespace {

const std::uint8_t* octets(const void* data) {
    return static_cast<const std::uint8_t*>(data);
}

std::string replaced(std::string_view text, std::string_view (*replacement)(char)) {
    std::string result;
    result.reserve(text.size());
    for (const char c : text) {
        const std::string_view other = replacement(c);
        if (other.empty()) {
            result += c;
        } else {
            result += other;
        }
    }
    return result;
}

bool is_plain_in_url(unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(static_cast<char>(c)) || c == '-' || c == '_' ||
           c == '.' || c == '~' || c == '/';
}

}  // namespace

std::string html_text(std::string_view text) {
    return replaced(text, [](char c) -> std::string_view {
        switch (c) {
            case '&':
                return "&amp;";
            case '<':
                return "&lt;";
            case '>':
                return "&gt;";
            case '"':
                return "&quot;";
            case '\'':
                return "&#39;";
            default:
                return {};
        }
    });
}

std::string script_json(const std::string& json) {
    // In JSON, these characters occur only in strings, where they can be escaped.
    return replaced(json, [](char c) -> std::string_view {
        switch (c) {
            case '<':
                return "\\u003c";
            case '>':
                return "\\u003e";
            case '&':
                return "\\u0026";
            default:
                return {};
        }
    });
}

std::string base64(std::span<const std::byte> bytes) {
    // libav's encoder counts in int and appends a zero. Parts with a multiple of three bytes need no padding.
    constexpr std::size_t part = 3 << 20;
    std::string text;
    text.reserve(bytes.size() / 3 * 4 + 8);
    std::vector<char> room(AV_BASE64_SIZE(part));
    for (; !bytes.empty(); bytes = bytes.subspan(std::min(part, bytes.size()))) {
        const std::size_t count = std::min(part, bytes.size());
        av_base64_encode(room.data(), static_cast<int>(room.size()), octets(bytes.data()), static_cast<int>(count));
        text += room.data();
    }
    return text;
}

std::string deflated_base64(std::span<const std::uint8_t> bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::vector<std::uint8_t> packed(size);
    constexpr int level = 6;
    if (compress2(packed.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), level) != Z_OK)
        throw Error(ErrorCode::out_of_memory, "there is no memory to pack the volume of the page");
    return base64(std::as_bytes(std::span(packed).first(size)));
}

std::string data_url(const std::string& type, std::span<const std::byte> bytes) {
    return fmt::format("data:{};base64,{}", type, base64(bytes));
}

std::string policy_hash(std::string_view text) {
    return "'sha256-" + base64(sha256(text)) + "'";
}

std::string url_of_path(std::string_view path) {
    // Without "./", a first part with a colon would be a URL scheme.
    std::string url = "./";
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        url += is_plain_in_url(byte) ? std::string(1, c) : fmt::format("%{:02X}", byte);
    }
    return url;
}

std::string relative_url(const std::filesystem::path& page, const std::filesystem::path& file) {
    // Browsers resolve `..` in the URL's text, so symbolic links are not resolved here.
    const auto whole = [](const std::filesystem::path& path) {
        return std::filesystem::absolute(path).lexically_normal();
    };
    return url_of_path(whole(file).lexically_relative(whole(page).parent_path()).string());
}

std::string fill(std::string_view text, const std::vector<std::pair<std::string_view, std::string>>& values) {
    std::string filled;
    for (;;) {
        const std::size_t open = text.find("{{");
        filled += text.substr(0, open);
        if (open == std::string_view::npos) return filled;
        const std::size_t close = text.find("}}", open);
        if (close == std::string_view::npos) throw std::out_of_range("a placeholder in a page has no end");
        const std::string_view name = text.substr(open + 2, close - open - 2);
        const auto value = std::ranges::find(values, name, &std::pair<std::string_view, std::string>::first);
        if (value == values.end())
            throw std::out_of_range(fmt::format("the placeholder '{}' in a page has no value", name));
        filled += value->second;
        text.remove_prefix(close + 2);
    }
}

namespace {

/// The name of an emphasis, which is also a CSS class.
std::string_view name_of(tracking::Emphasis emphasis) {
    switch (emphasis) {
        case tracking::Emphasis::none:
            return "none";
        case tracking::Emphasis::standing:
            return "standing";
        case tracking::Emphasis::strong:
            return "strong";
    }
    return {};
}

std::string_view name_of(tracking::Tally tally) {
    switch (tally) {
        case tracking::Tally::none:
            return "none";
        case tracking::Tally::lasts:
            return "lasts";
        case tracking::Tally::still:
            return "still";
        case tracking::Tally::count:
            return "count";
    }
    return {};
}

}  // namespace

Json json_of_kinds() {
    return list_of(tracking::ranked_kinds(), [](const tracking::EventKindRow& row) {
        return Json{{"name", row.name},
                    {"words", row.words},
                    {"by", row.by},
                    {"isThing", row.is_thing},
                    {"isOfScene", row.is_of_scene},
                    {"emphasis", name_of(row.emphasis)},
                    {"tally", name_of(row.tally)},
                    {"choice", row.choice != nullptr ? Json(row.choice->name) : Json()}};
    });
}

}  // namespace vvr::page
