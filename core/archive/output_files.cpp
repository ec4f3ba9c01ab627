#include "core/archive/output_files.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"

namespace vvr::archive {

namespace {

namespace fs = std::filesystem;

fs::path with_extension(const fs::path& out, const std::string& clip, std::string_view extension) {
    return out / (clip + std::string(extension));
}

}  // namespace

std::string text_of_path(std::string_view path) {
    std::string text;
    while (!path.empty()) {
        const auto byte = static_cast<unsigned char>(path[0]);
        const std::optional<Character> character = first_character(path);
        const std::size_t length = character ? character->length : 1;
        if (!character || byte < 0x20 || byte == 0x7F || byte == '%') {
            text += fmt::format("%{:02X}", byte);
        } else {
            text += path.substr(0, length);
        }
        path.remove_prefix(length);
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
    return with_extension(out, clip, std::ranges::find(output_rows, kind, &OutputRow::kind)->extension);
}

fs::path sidecar_path(const fs::path& out, const std::string& clip) {
    return with_extension(out, clip, sidecar_extension);
}

namespace {

constexpr std::array strange{
    std::pair{fs::file_type::symlink, std::string_view("a link")},
    std::pair{fs::file_type::directory, std::string_view("a folder")},
    std::pair{fs::file_type::fifo, std::string_view("a pipe")},
    std::pair{fs::file_type::socket, std::string_view("a socket")},
    std::pair{fs::file_type::character, std::string_view("a device")},
    std::pair{fs::file_type::block, std::string_view("a device")},
};

/// Reads until the end, or until `text` would exceed `most` bytes.
/// \returns whether it reached the end
bool read_to_end(int file, std::string& text, std::size_t most) {
    std::array<char, 65536> room{};
    for (;;) {
        const ssize_t count = ::read(file, room.data(), room.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0 || text.size() + static_cast<std::size_t>(count) > most) return false;
        if (count == 0) return true;
        text.append(room.data(), static_cast<std::size_t>(count));
    }
}

}  // namespace

std::optional<std::string_view> irregular_file_at(const fs::path& path) {
    std::error_code none;
    const auto* const found =
        std::ranges::find(strange, fs::symlink_status(path, none).type(), &decltype(strange)::value_type::first);
    return found == strange.end() ? std::nullopt : std::optional(found->second);
}

bool is_own_file(const fs::path& path) {
    std::error_code none;
    return fs::is_regular_file(fs::symlink_status(path, none));
}

bool remove_own(const fs::path& file, std::error_code& error) {
    return is_own_file(file) && fs::remove(file, error);
}

bool remove_own(const fs::path& file) {
    std::error_code error;
    const bool removed = remove_own(file, error);
    if (error) {
        throw system_error(error.value(), fmt::format("cannot remove '{}'", file.string()),
                           "fix the permissions of its folder");
    }
    return removed;
}

void check_own_place(const fs::path& file) {
    if (const auto what = irregular_file_at(file)) {
        throw Error(ErrorCode::not_a_file, fmt::format("cannot write '{}': it is {}; remove it", file.string(), *what));
    }
}

void check_own_folder(const fs::path& out, const fs::path& folder) {
    fs::path place = out;
    for (const fs::path& name : folder.lexically_relative(out)) {
        if (name == ".") continue;
        place /= name;
        const auto what = irregular_file_at(place);
        if (!what || *what == "a folder") continue;
        throw Error(ErrorCode::not_a_folder,
                    fmt::format("cannot write into '{}': it is {}, not a folder of this archive; remove it",
                                place.string(), *what));
    }
}

OwnText read_own(const fs::path& path, std::string_view beginning, std::size_t most) {
    const int file = open_no_follow(path, O_RDONLY);
    if (file < 0) {
        const auto what = irregular_file_at(path);
        return {{}, what && *what != "a folder" ? fmt::format("it is {}, not a file", *what) : ""};
    }
    OwnText own;
    std::string text(beginning.size(), 0);
    if (::read(file, text.data(), text.size()) == static_cast<ssize_t>(text.size()) && text == beginning) {
        // Checks the size first: a sparse file may be huge.
        struct stat status {};
        if (::fstat(file, &status) == 0 && static_cast<std::size_t>(status.st_size) <= most &&
            read_to_end(file, text, most)) {
            own.text = std::move(text);
        } else {
            own.problem =
                fmt::format("it cannot be read: it has {} bytes, and at most {} are allowed", status.st_size, most);
        }
    }
    ::close(file);
    return own;
}

}  // namespace vvr::archive
