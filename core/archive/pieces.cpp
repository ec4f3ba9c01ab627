#include "core/archive/pieces.h"

#include <algorithm>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "core/archive/output_files.h"
#include "core/base/error.h"
#include "core/footage/piece_names.h"

namespace vvr::archive {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view piece_extension = ".events";

bool is_folder(const fs::path& path) {
    std::error_code none;
    return fs::is_directory(fs::symlink_status(path, none));
}

}  // namespace

fs::path pieces_folder(const fs::path& out, const std::string& clip) {
    return out / (clip + std::string(piece_extension));
}

bool is_pieces_folder(const fs::path& folder) {
    return folder.extension() == piece_extension && is_own_file(folder / footage::record_name);
}

std::vector<std::string> list_pieces(const fs::path& folder) {
    std::vector<std::string> names;
    if (!is_folder(folder)) return names;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (footage::is_piece_name(name) && is_own_file(entry->path())) names.push_back(name);
    }
    std::ranges::sort(names);
    return names;
}

bool has_pieces(const fs::path& folder, std::span<const std::string> names) {
    return names.empty() || (is_folder(folder) && std::ranges::all_of(names, [&](const std::string& name) {
                                 return is_own_file(folder / name);
                             }));
}

void move_pieces(const fs::path& from, const fs::path& folder, std::span<const std::string> names) {
    if (names.empty()) return;
    check_own_folder(folder.parent_path(), folder);
    std::error_code error;
    fs::create_directory(folder, error);
    if (error) {
        throw system_error(error.value(), fmt::format("cannot create the folder '{}'", folder.string()),
                           "choose another -o, or remove what is in its place");
    }
    for (const std::string& name : names) check_own_place(folder / name);
    for (const std::string& name : names) {
        fs::rename(from / name, folder / name, error);
        if (!error) continue;
        throw system_error(error.value(), fmt::format("cannot write '{}'", (folder / name).string()),
                           "choose another folder or fix its permissions");
    }
}

std::vector<fs::path> remove_pieces(const fs::path& folder, std::span<const std::string> names) {
    std::vector<fs::path> removed;
    if (names.empty() || !is_folder(folder)) return removed;
    for (const std::string& name : names) {
        if (remove_own(folder / name)) removed.push_back(folder / name);
    }
    std::error_code not_empty;
    fs::remove(folder, not_empty);
    return removed;
}

}  // namespace vvr::archive
