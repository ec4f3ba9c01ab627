#include "core/archive/names.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

#include <fmt/format.h>

#include "core/base/shown_text.h"

namespace vvr::archive {

namespace {

namespace fs = std::filesystem;

fs::path with_extension(const fs::path& out, const std::string& clip, std::string_view ending) {
    return out / (clip + std::string(ending));
}

}  // namespace

std::string text_of_path(std::string_view path) {
    std::string text;
    while (!path.empty()) {
        const auto byte = static_cast<unsigned char>(path[0]);
        const std::size_t length = character_length(path);
        if (length == 0 || byte < 0x20 || byte == 0x7F || byte == '%') {
            text += fmt::format("%{:02X}", byte);
            path.remove_prefix(1);
        } else {
            text += path.substr(0, length);
            path.remove_prefix(length);
        }
    }
    return text;
}

std::string path_of_text(std::string_view text) {
    std::string path;
    for (std::size_t k = 0; k < text.size(); ++k) {
        std::uint8_t byte = 0;
        const char* const digits = text.data() + k + 1;
        if (text[k] == '%' && k + 2 < text.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
            path += static_cast<char>(byte);
            k += 2;
        } else {
            path += text[k];
        }
    }
    return path;
}

fs::path output_path(const fs::path& out, const std::string& clip, OutputKind kind) {
    return with_extension(out, clip, std::ranges::find(output_rows, kind, &OutputRow::kind)->ending);
}

fs::path sidecar_path(const fs::path& out, const std::string& clip) {
    return with_extension(out, clip, sidecar_extension);
}

}  // namespace vvr::archive
