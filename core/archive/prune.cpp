#include "core/archive/prune.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include <sys/stat.h>

#include <fmt/format.h>

#include "core/archive/clips.h"
#include "core/archive/pieces.h"
#include "core/base/atomic_file.h"
#include "core/base/digest.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/footage/input_files.h"

namespace vvr::archive {

namespace {

namespace fs = std::filesystem;

/// Whether a folder's name is a date or a number, such as recorders create and remove. Letters are only in dates that
/// begin with the year ("2026Y11M21D"): "D01" and "192.168.1.10" are cameras.
bool is_time_folder(std::string_view folder) {
    const auto digits = std::ranges::count_if(folder, is_digit);
    const auto others = std::ranges::count_if(folder, [](char c) { return c != '-' && c != '_' && c != '.'; }) - digits;
    const bool is_address = std::ranges::count(folder, '.') == 3 && folder.find('.') <= 3;
    if (others == 0) return digits > 0 && !is_address;
    const bool has_year =
        (folder.starts_with("19") || folder.starts_with("20")) && std::ranges::all_of(folder.substr(0, 4), is_digit);
    return has_year && digits >= 2 * others;
}

/// Whether a folder shows nothing, or can't be read. The scan skips hidden names, and mount points often have some.
bool seems_empty(const fs::path& folder) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        if (!entry->path().filename().string().starts_with('.')) return false;
    }
    return true;
}

/// The folder of a missing clip, if it may be an unmounted disk: an empty folder, a broken link, or a camera's own
/// top-level folder without clips.
std::optional<std::string> missing_folder(const fs::path& in, const std::string& clip, const Present& present,
                                          const footage::RecorderNames& recorders) {
    fs::path missing;
    fs::path folder = fs::path(clip).parent_path();
    std::error_code none;
    while (!folder.empty() && !fs::is_directory(in / folder, none)) {
        if (!is_gone(in / folder)) return folder.string();
        missing = folder;
        folder = folder.parent_path();
    }
    if (!folder.empty()) return seems_empty(in / folder) ? std::optional(folder.string()) : std::nullopt;
    const std::string top = missing.string();
    if (top.empty() || is_time_folder(top) || present.cameras.contains(recorders.camera_of(clip))) return std::nullopt;
    return top;
}

/// The files in use: the index, and the files of clips with a sidecar.
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
    if (is_gone(out)) return outputs;
    std::error_code error;
    fs::recursive_directory_iterator entry(out, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        const fs::path& path = entry->path();
        std::error_code none;
        const bool hidden = path.filename().string().starts_with('.');
        if (entry->is_directory(none)) {
            std::error_code closed;
            // Only root may read lost+found, which each file system of the ext family has at its top.
            if (hidden || footage::is_system_folder_name(path.filename().string()) || fs::equivalent(path, in, none)) {
                entry.disable_recursion_pending();
            } else if (fs::directory_iterator(path, closed); closed) {
                outputs.problems.push_back({path.lexically_relative(out).string(), closed.message(), true});
                entry.disable_recursion_pending();
            }
        } else if (LockFile::is_lock_file(path)) {
            outputs.locks.push_back(path);
        } else if (!hidden && path.extension() == sidecar_extension) {
            const std::string name = path.lexically_relative(out).string();
            std::string problem;
            auto sidecar = read_sidecar_file(out, name, &problem);
            if (sidecar) outputs.sidecars.push_back(std::move(*sidecar));
            if (!problem.empty()) outputs.problems.push_back({name, std::move(problem)});
        }
    }
    if (error)
        throw system_error(error.value(), fmt::format("cannot read '{}'", out.string()),
                           "check its name and permissions");
    std::ranges::sort(outputs.problems, {}, &ScanProblem::path);
    std::ranges::sort(outputs.sidecars, {}, [](const Sidecar& sidecar) { return sidecar.clip.path; });
    return outputs;
}

fs::path staging_of(const fs::path& out, const std::string& clip) {
    const fs::path place = out / clip;
    return place.parent_path() / fmt::format(".vvr-{:016x}.new", fnv1a(place.filename().string()));
}

void remove_staging(const fs::path& staging) {
    // An empty folder can be removed even if no more files can be opened; a full one can't even be listed then.
    std::error_code none;
    if (!fs::remove(staging, none)) fs::remove_all(staging, none);
}

std::vector<std::string> written_names(const std::string& file_name) {
    std::vector<std::string> names{file_name, sidecar_path("", file_name).string()};
    for (const OutputRow& row : output_rows) names.push_back(output_path("", file_name, row.kind).string());
    return names;
}

namespace {

/// Removes the files of a clip without a sidecar that a killed run made.
/// \param owned files that belong to other clips, or to the archive
void remove_unnamed_files(const fs::path& folder, const std::string& name, const std::set<fs::path>& owned,
                          const LockFile& claim) {
    struct stat lock {};
    if (::fstat(claim.descriptor(), &lock) != 0) return;
    const auto stays = [&](const fs::path& file) {
        struct stat made {};
        return owned.contains(file) || ::lstat(file.c_str(), &made) != 0 ||
               std::pair(made.st_mtim.tv_sec, made.st_mtim.tv_nsec) <
                   std::pair(lock.st_mtim.tv_sec, lock.st_mtim.tv_nsec);
    };
    std::error_code none;
    for (const OutputRow& row : output_rows) {
        const fs::path path = output_path(folder, name, row.kind);
        // The report of clip `x` has the path of the sidecar of clip `x.report`, and the page of a clip `index`
        // that of the index.
        if (!stays(path)) remove_own(path, none);
    }
    const fs::path pieces = pieces_folder(folder, name);
    std::vector<std::string> names = list_pieces(pieces);
    std::erase_if(names, [&](const std::string& piece) { return stays(pieces / piece); });
    remove_pieces(pieces, names);
}

/// Removes temporary files of a killed program.
/// \returns whether the clip has a sidecar
bool remove_hidden_files(const fs::path& folder, const std::string& name) {
    remove_leftovers(folder, written_names(name));
    remove_staging(staging_of(folder, name));
    std::error_code none;
    return fs::exists(sidecar_path(folder, name), none);
}

}  // namespace

void remove_unfinished(const fs::path& out, const fs::path& in, const std::string& clip, const LockFile& claim) {
    const fs::path folder = sidecar_path(out, clip).parent_path();
    const std::string name = fs::path(clip).filename().string();
    if (remove_hidden_files(folder, name)) return;
    remove_unnamed_files(folder, name, files_with_owners(out, list_outputs(out, in)), claim);
}

void tidy(const fs::path& out, const Outputs& outputs) {
    if (outputs.locks.empty()) return;
    const std::set<fs::path> owned = files_with_owners(out, outputs);
    for (const fs::path& file : outputs.locks) {
        const auto left = LockFile::take_over(file);
        if (left && !remove_hidden_files(file.parent_path(), left->second))
            remove_unnamed_files(file.parent_path(), left->second, owned, left->first);
    }
}

std::optional<std::vector<std::string>> remove_clip(const fs::path& out, const fs::path& in, const Sidecar& sidecar) {
    const fs::path folder = sidecar_path(out, sidecar.clip.path).parent_path();
    const std::string name = fs::path(sidecar.clip.path).filename().string();
    check_own_folder(out, folder);
    const auto claim = LockFile::try_take(folder, name);
    if (!claim) return std::nullopt;
    // Another run may have drawn it since the caller has read the sidecar.
    const std::optional<Sidecar> now = read_sidecar(out, sidecar.clip.path);
    const bool same = now && format_sidecar(*now) == format_sidecar(sidecar);
    std::optional<std::vector<std::string>> removed;
    if (same) removed = remove_outputs(out, sidecar);
    // The lock of a killed run goes with the claim, so `tidy` would not find it.
    if (claim->is_stale()) remove_unfinished(out, in, sidecar.clip.path, *claim);
    return removed;
}

Present find_present(const fs::path& in, const fs::path& out, const ClipNames& names,
                     const footage::RecorderNames& recorders, const std::vector<Sidecar>& sidecars) {
    Present present{scan_archive(in, out, names.with_all()), {}, {}};
    // With no time to wait, no clip is left out.
    const Settling all{std::chrono::system_clock::now(), std::chrono::nanoseconds(0)};
    std::set<DayRule> rules{DayRule()};
    for (const Sidecar& sidecar : sidecars) {
        if (sidecar.day) rules.insert(sidecar.day->rule);
    }
    for (const DayRule& rule : rules) {
        for (const CameraDay& day : group_by_day(present.scan.clips, recorders, all, rule, in).days)
            present.days.insert(day.clip.path);
    }
    for (const Clip& clip : present.scan.clips) present.cameras.insert(recorders.camera_of(clip.path));
    return present;
}

SourceStatus source_state_of(const fs::path& in, const Sidecar& sidecar, const Present& present,
                             const footage::RecorderNames& recorders) {
    if (present.days.contains(sidecar.clip.path)) return {};
    if (sidecar.day && sidecar.day->files.empty()) return {SourceState::unknown, {}};
    const auto is_found = [&](const std::string& clip) {
        return std::ranges::binary_search(present.scan.clips, clip, {}, &Clip::path);
    };
    if (sidecar.day && std::ranges::all_of(sidecar.day->files, is_found)) return {SourceState::moved, {}};
    std::set<fs::path> looked_at;
    for (const std::string& clip : sidecar.day ? sidecar.day->files : std::vector{sidecar.clip.path}) {
        if (!is_gone(in / clip)) return {};
        if (!looked_at.insert(fs::path(clip).parent_path()).second) continue;
        if (auto folder = missing_folder(in, clip, present, recorders)) return {SourceState::away, std::move(*folder)};
    }
    return {SourceState::gone, {}};
}

void check_can_prune(const fs::path& in, const Present& present) {
    const auto unread = std::ranges::find(present.scan.problems, true, &ScanProblem::unread);
    if (unread != present.scan.problems.end()) {
        throw Error(
            ErrorCode::io,
            fmt::format("cannot prune: cannot read '{}': {}; fix that first, because clips there may still exist",
                        (in / unread->path).string(), unread->reason));
    }
    if (present.scan.clips.empty()) {
        throw Error(
            ErrorCode::archive_empty,
            fmt::format(
                "cannot prune: '{}' has no clips; check that its disk is mounted, or remove the pictures yourself",
                in.string()));
    }
}

}  // namespace vvr::archive
