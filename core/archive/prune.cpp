#include "core/archive/prune.h"

#include <algorithm>
#include <cerrno>
#include <set>
#include <system_error>
#include <utility>

#include <sys/stat.h>

#include <fmt/format.h>

#include "core/archive/claim.h"
#include "core/error.h"
#include "core/image/atomic_file.h"

namespace vvr {

namespace {

namespace fs = std::filesystem;

/// The nearest folder above a clip that exists.
std::string folder_left(const fs::path& in, const std::string& clip) {
    fs::path folder = fs::path(clip).parent_path();
    std::error_code none;
    while (!folder.empty() && !fs::is_directory(in / folder, none)) folder = folder.parent_path();
    return folder.string();
}

/// The files in use: the index, and those of clips that have a sidecar.
std::set<fs::path> files_with_owners(const fs::path& out, const Outputs& outputs) {
    std::set<fs::path> files{out / index_name};
    for (const Sidecar& sidecar : outputs.sidecars) {
        files.insert(sidecar_path(out, sidecar.clip.path));
        for (const OutputKind kind : sidecar.files) files.insert(output_path(out, sidecar.clip.path, kind));
    }
    return files;
}

}  // namespace

bool is_gone(const fs::path& path) {
    struct stat status {};
    return ::lstat(path.c_str(), &status) != 0 && (errno == ENOENT || errno == ENOTDIR);
}

Outputs list_outputs(const fs::path& out, const fs::path& in) {
    Outputs outputs;
    std::error_code error;
    fs::recursive_directory_iterator entry(out, fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        const fs::path& path = entry->path();
        std::error_code none;
        const bool hidden = path.filename().string().starts_with('.');
        if (entry->is_directory(none)) {
            if (hidden || fs::equivalent(path, in, none)) entry.disable_recursion_pending();
        } else if (Claim::is_claim(path)) {
            outputs.claims.push_back(path);
        } else if (!hidden && path.extension() == sidecar_ending) {
            auto sidecar = read_sidecar_file(out, path.lexically_relative(out).string());
            if (sidecar) outputs.sidecars.push_back(std::move(*sidecar));
        }
    }
    if (error) {
        throw Error(ErrorKind::io, fmt::format("cannot read '{}': {}; check the name and its permissions", out.string(),
                                               error.message()));
    }
    std::ranges::sort(outputs.sidecars, {}, [](const Sidecar& sidecar) { return sidecar.clip.path; });
    return outputs;
}

std::vector<std::string> written_names(const std::string& file_name) {
    std::vector<std::string> names{file_name, sidecar_path("", file_name).string()};
    for (const OutputRow& row : output_rows) names.push_back(output_path("", file_name, row.kind).string());
    return names;
}

void tidy(const fs::path& out, const Outputs& outputs) {
    if (outputs.claims.empty()) return;
    const std::set<fs::path> owned = files_with_owners(out, outputs);
    for (const fs::path& file : outputs.claims) {
        const auto left = Claim::take_over(file);
        if (!left) continue;
        const fs::path folder = file.parent_path();
        const std::string& name = left->second;
        remove_leftovers(folder, written_names(name));
        std::error_code none;
        if (fs::exists(sidecar_path(folder, name), none)) continue;
        // No run came back to finish it, and no sidecar will ever name these files.
        for (const OutputRow& row : output_rows) {
            const fs::path path = output_path(folder, name, row.kind);
            // `x` has its report where `x.report` has its sidecar, and a clip `index` its page where the index is.
            if (owned.contains(path) || !fs::is_regular_file(fs::symlink_status(path, none))) continue;
            fs::remove(path, none);
        }
    }
}

Gone find_gone(const fs::path& in, const std::vector<Sidecar>& sidecars, std::size_t clips_there) {
    if (clips_there == 0 && !sidecars.empty()) {
        throw Error(ErrorKind::io, fmt::format("no clip is left in '{}', so nothing is pruned; if its disk is mounted "
                                               "and they are gone for good, remove the pictures yourself",
                                               in.string()));
    }
    Gone gone;
    std::set<std::string> empty;
    for (const Sidecar& sidecar : sidecars) {
        if (!is_gone(in / sidecar.clip.path)) continue;
        const std::string folder = folder_left(in, sidecar.clip.path);
        std::error_code none;
        if (!folder.empty() && fs::is_empty(in / folder, none)) {
            empty.insert(folder);
        } else {
            gone.sidecars.push_back(sidecar);
        }
    }
    gone.empty_folders.assign(empty.begin(), empty.end());
    return gone;
}

}  // namespace vvr
