#include "core/archive/clips.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <ctime>
#include <deque>
#include <map>
#include <set>
#include <system_error>
#include <unordered_set>
#include <utility>

#include <fnmatch.h>
#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/vfs.h>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/archive/output_files.h"
#include "core/archive/pieces.h"
#include "core/base/digest.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/wall_clock.h"
#include "core/footage/input_files.h"
#include "core/media/demuxer.h"

namespace vvr::archive {

namespace {

std::string_view file_name(std::string_view path) {
    return path.substr(path.rfind('/') + 1);
}

bool fits(const std::string& pattern, const std::string& clip) {
    const bool whole = pattern.find('/') != std::string::npos;
    return ::fnmatch(pattern.c_str(), (whole ? clip : std::string(file_name(clip))).c_str(),
                     whole ? FNM_PATHNAME : 0) == 0;
}

}  // namespace

bool ClipNames::matches(const std::string& clip) const {
    const auto fits_clip = [&](const std::string& pattern) { return fits(pattern, clip); };
    if (std::ranges::any_of(excluded_, fits_clip)) return false;
    const std::string name(file_name(clip));
    if (videos_ && (footage::is_video_name(name) || (pictures_ && footage::is_picture_name(name)))) return true;
    return std::ranges::any_of(patterns_, fits_clip);
}

ClipNames ClipNames::with_all() const {
    ClipNames all(patterns_, {}, pictures_);
    all.videos_ = true;
    return all;
}

std::string ClipNames::wanted() const {
    std::string names;
    if (videos_) names = fmt::format("{}", fmt::join(footage::video_extensions(), " "));
    if (videos_ && pictures_) names += ", and for pictures with a time in their names";
    return patterns_.empty() ? names : fmt::format("{}", fmt::join(patterns_, " "));
}

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t second = 1'000'000'000;

Clip clip_of(const std::string& path, const struct stat& status) {
    const std::int64_t written = status.st_mtim.tv_sec;
    if (written < 0) return {path, status.st_size, 0};
    if (written >= last_time) return {path, status.st_size, (last_time - 1) * second};
    return {path, status.st_size, written * second + status.st_mtim.tv_nsec};
}

/// Whether a folder is on a file system of the kernel, whose files aren't real: /proc, /sys and such.
bool is_kernel_filesystem(const fs::path& folder) {
    constexpr std::array<long, 11> kinds{PROC_SUPER_MAGIC,   SYSFS_MAGIC,         DEBUGFS_MAGIC,      TRACEFS_MAGIC,
                                         CGROUP_SUPER_MAGIC, CGROUP2_SUPER_MAGIC, DEVPTS_SUPER_MAGIC, SECURITYFS_MAGIC,
                                         BPF_FS_MAGIC,       PSTOREFS_MAGIC,      EFIVARFS_MAGIC};
    struct statfs status {};
    return ::statfs(folder.c_str(), &status) == 0 && std::ranges::count(kinds, static_cast<long>(status.f_type)) > 0;
}

/// Reads folders; those reached only through links come last.
class Walk {
  public:
    Walk(const fs::path& in, const fs::path& out, const ClipNames& names) : in_(in), names_(names) {
        struct stat status {};
        if (::stat(out.c_str(), &status) == 0) seen_.emplace(status.st_dev, status.st_ino);
        if (::stat(in.c_str(), &status) == 0 && !S_ISDIR(status.st_mode)) {
            throw Error(
                ErrorCode::not_a_folder,
                fmt::format(
                    "'{}' is a file; give a folder of clips, or draw one clip with: vvr render '{}' -o picture.png",
                    in.string(), in.string()));
        }
        if (::stat(in.c_str(), &status) != 0) {
            throw system_error(errno, fmt::format("cannot read the archive '{}'", in.string()),
                               "check its name, and that its disk is mounted");
        }
        // A link to a folder that contains this one could bring in the whole machine.
        std::error_code none;
        for (fs::path above = fs::canonical(in, none); above.has_relative_path();) {
            above = above.parent_path();
            struct stat folder {};
            if (::stat(above.c_str(), &folder) == 0) above_.emplace(folder.st_dev, folder.st_ino);
        }
        if (!seen_.emplace(status.st_dev, status.st_ino).second) {
            throw Error(ErrorCode::options_conflict,
                        fmt::format("'{}' is the folder of the clips, and cannot be that of their pictures too; choose "
                                    "another one, such as '{}'",
                                    in.string(), (in / "pictures").lexically_normal().string()));
        }
    }

    Scan run() {
        list("");
        if (!scan_.problems.empty() && scan_.problems.back().path.empty()) {
            throw Error(ErrorCode::permission_denied,
                        fmt::format("the archive '{}': {}", in_.string(), scan_.problems.back().reason));
        }
        for (; !folders_.empty() || !links_.empty();) {
            const bool link = folders_.empty();
            std::deque<std::string>& from = link ? links_ : folders_;
            const std::string folder = from.front();
            from.pop_front();
            enter(folder, link);
        }
        std::ranges::sort(scan_.clips, {}, &Clip::path);
        return std::move(scan_);
    }

  private:
    /// The recorder may delete what a folder has just listed. But a link to nothing may lead to an unmounted disk.
    void add_unread(const std::string& path, int error, bool link) {
        if (error == ENOENT && !link) return;
        scan_.problems.push_back(
            {path, fmt::format("it cannot be read: {}; fix that, or exclude it", text_of_system_error(error)), true});
    }

    void enter(const std::string& folder, bool link) {
        struct stat status {};
        if (::stat((in_ / folder).c_str(), &status) != 0) {
            add_unread(folder, errno, link);
        } else if (above_.contains({status.st_dev, status.st_ino})) {
            scan_.problems.push_back({folder, "it is a symbolic link to a folder above the archive; remove it"});
        } else if (!is_kernel_filesystem(in_ / folder) && !is_pieces_folder(in_ / folder) &&
                   seen_.emplace(status.st_dev, status.st_ino).second) {
            list(folder, link);
        }
    }

    void list(const std::string& folder, bool link = true) {
        std::error_code error;
        std::vector<std::pair<std::string, fs::file_type>> entries;
        for (fs::directory_iterator entry(in_ / folder, error); !error && entry != fs::directory_iterator();
             entry.increment(error)) {
            const std::string name = entry->path().filename().string();
            std::error_code none;
            if (!name.starts_with('.')) entries.emplace_back(name, entry->symlink_status(none).type());
        }
        std::ranges::sort(entries);  // deterministic: of several links to a folder, the same one is always taken
        for (const auto& [name, type] : entries) add(folder.empty() ? name : fmt::format("{}/{}", folder, name), type);
        if (error) add_unread(folder, error.value(), link);
    }

    /// Counts the clips in a folder that is skipped.
    void skip(const std::string& folder) {
        constexpr int most = 10'000;  // a NAS may keep many snapshots of everything
        std::error_code error;
        fs::recursive_directory_iterator entry(in_ / folder, fs::directory_options::skip_permission_denied, error);
        for (int i = 0; i < most && !error && entry != fs::recursive_directory_iterator();
             entry.increment(error), ++i) {
            std::error_code none;
            if (!names_.matches(entry->path().lexically_relative(in_).string()) || entry->is_directory(none)) continue;
            ++scan_.skipped;
            scan_.system_folders.insert(folder);
        }
    }

    void add(const std::string& path, fs::file_type type) {
        if (footage::is_system_folder_name(std::string(file_name(path))) && type == fs::file_type::directory) {
            skip(path);
            return;
        }
        if (type == fs::file_type::directory) {
            folders_.push_back(path);
            return;
        }
        const bool clip = names_.matches(path);
        const bool link = type == fs::file_type::symlink;
        if (!clip && !link) return;
        if (clip && media::is_playlist_name(path)) {
            scan_.problems.push_back({path, "it is a playlist, not a video file; exclude it"});
            return;
        }
        struct stat status {};
        if (::stat((in_ / path).c_str(), &status) != 0) {
            if (clip) add_unread(path, errno, link);
        } else if (S_ISDIR(status.st_mode)) {
            if (link) links_.push_back(path);
        } else if (clip && S_ISREG(status.st_mode)) {
            scan_.clips.push_back(clip_of(path, status));
        }
    }

    const fs::path& in_;
    const ClipNames& names_;
    std::set<std::pair<dev_t, ino_t>> seen_;
    std::set<std::pair<dev_t, ino_t>> above_;
    std::deque<std::string> folders_;
    std::deque<std::string> links_;
    Scan scan_;
};

/// Drops clips with too long a name for one of their output files. All kinds of output count, requested or not, so that
/// options don't change the set of clips.
void drop_long_names(Scan& scan) {
    std::erase_if(scan.clips, [&](const Clip& clip) {
        std::string longest = sidecar_path("", clip.path).filename().string();
        for (const OutputRow& row : output_rows) {
            const std::string file = output_path("", clip.path, row.kind).filename().string();
            if (file.size() > longest.size()) longest = file;
        }
        if (longest.size() <= longest_name) return false;
        scan.problems.push_back(
            {clip.path,
             fmt::format("the name of its file '{}' would have {} bytes, more than {}; shorten the name of the clip",
                         text_of_path(longest), longest.size(), longest_name)});
        return true;
    });
}

/// Drops clips whose output files would replace those of other clips.
void drop_conflicts(Scan& scan) {
    std::unordered_set<std::string> taken{std::string(index_name)};
    std::unordered_set<std::string> folders;
    for (const Clip& clip : scan.clips) {
        for (auto slash = clip.path.find('/'); slash != std::string::npos; slash = clip.path.find('/', slash + 1)) {
            folders.insert(clip.path.substr(0, slash));
        }
    }
    std::erase_if(scan.clips, [&](const Clip& clip) {
        std::vector<std::string> files{sidecar_path("", clip.path).string()};
        for (const OutputRow& row : output_rows) files.push_back(output_path("", clip.path, row.kind).string());
        for (const std::string& file : files) {
            if (!taken.contains(file) && !folders.contains(file)) continue;
            scan.problems.push_back(
                {clip.path, fmt::format("its file '{}' would replace {}; rename the clip", text_of_path(file),
                                        folders.contains(file) ? "a folder of clips" : "another file of the archive")});
            return true;
        }
        taken.insert(files.begin(), files.end());
        return false;
    });
}

}  // namespace

Scan scan_archive(const fs::path& in, const fs::path& out, const ClipNames& names) {
    Scan scan = Walk(in, out, names).run();
    drop_long_names(scan);
    drop_conflicts(scan);
    std::ranges::sort(scan.problems, {}, &ScanProblem::path);
    return scan;
}

std::optional<Clip> stat_clip(const fs::path& in, const std::string& path) {
    struct stat status {};
    if (::stat((in / path).c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    return clip_of(path, status);
}

bool Settling::waits_for(const Clip& clip) const {
    const std::chrono::system_clock::time_point modified{std::chrono::nanoseconds(clip.modified)};
    return modified > now - settle && modified < now + settle;
}

bool Settling::is_ahead(const Clip& clip) const {
    const std::chrono::system_clock::time_point modified{std::chrono::nanoseconds(clip.modified)};
    return modified >= now + settle && modified > now;
}

bool Shard::contains(std::string_view clip) const {
    return fnv1a(clip) % count == index;
}

}  // namespace vvr::archive
