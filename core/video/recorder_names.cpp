#include "core/video/recorder_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/base/text.h"
#include "core/base/wall_clock.h"
#include "core/video/camera_names.h"
#include "core/video/pattern_set.h"

namespace vvr::video {

namespace {

enum class Zone { local, utc };

struct KnownRow {
    std::string_view recorder;
    std::string_view pattern;
    Zone zone = Zone::local;
    NamedCamera camera = NamedCamera::whole;
    Ambiguity doubt = Ambiguity::none;
};

constexpr std::string_view any_name = "a date and a time";
constexpr std::string_view any_folder = "a folder of a date";
constexpr std::string_view any_epoch = "seconds since 1970";
constexpr auto local = Zone::local;
constexpr auto below = NamedCamera::below;
constexpr auto folder = NamedCamera::folder;

// The fields in braces are defined in core/video/recorder_pattern.cpp. Specific rows come first, because the last ones
// match many names.
constexpr std::array known{
    KnownRow{"Frigate", "%Y-%m-%d/%H/{camera}/%M.%S", Zone::utc},
    KnownRow{"Frigate", "%Y-%m/%d/%H/{camera}/%M.%S"},  // before version 0.12
    KnownRow{"Frigate", "{camera}-{epoch}.{number}-*"},
    KnownRow{"Dahua", "%Y-%m-%d/001/dav/%H/%H.%M.%S-*"},
    KnownRow{"Dahua", "%Y-%m-%d/{camera}/dav/%H/%H.%M.%S-*", local, folder},
    KnownRow{"Dahua", "{dated}/%H.%M.%S-{number}.{number}.{number}[*"},
    KnownRow{"Dahua", "{camera}_main_%Y%m%d%H%M%S_*"},
    KnownRow{"Dahua", "{camera}_sub_%Y%m%d%H%M%S_*"},
    KnownRow{"Hikvision", "{camera}_hiknvr_%Y%m%d%H%M%S_*"},
    KnownRow{"Reolink", "{camera}_00_%Y%m%d%H%M%S"},
    KnownRow{"Reolink", "Rec*%Y%m%d_%H%M%S_*"},  // on the camera's SD card
    KnownRow{"Hikvision", "{camera}_%Y%m%d%H%M%S{number}"},
    KnownRow{"Synology", "{camera}-%Y%m%d-%H%M%S-{number}*"},
    KnownRow{"Blue Iris", "{camera}.%Y%m%d_%H%M%S*"},
    KnownRow{"UniFi", "{camera} %-m-%-d-%Y, %-H.%M.%S GMT%z*"},
    KnownRow{"UniFi", "{camera} %-m-%-d-%Y, %-H.%M.%S*", local, NamedCamera::whole, Ambiguity::day_or_month},
    KnownRow{"ZoneMinder", "{camera}/%y/%m/%d/%H/%M/%S/{number}-video"},
    KnownRow{"ZoneMinder", "{camera}/%Y-%m-%d/{number}/{number}-video"},
    KnownRow{"Xiaomi", "%Y%m%d%H/%MM%SS_{epoch}"},
    KnownRow{"Xiaomi", "%YY%mM%dD%HH/%MM%SS*"},
    KnownRow{"motion", "{number}-%Y%m%d%H%M%S"},
    KnownRow{"motion", "%Y-%m-%d/%H-%M-%S"},  // motionEye
    // The time is that of sending, and day and month may be swapped.
    KnownRow{"", "WhatsApp *", local, NamedCamera::whole, Ambiguity::always},
    KnownRow{"", "{unsure date}", local, NamedCamera::whole, Ambiguity::always},
    // Date and time in the name, with the camera before them, after them, or without it.
    KnownRow{any_name, "{date}{join}{clock}{fraction}{zone}"},
    KnownRow{any_name, "{date}T{clock}%z"},
    KnownRow{any_name, "{moment}{gap}{side}", local, below},
    KnownRow{any_name, "{moment}{more}"},
    KnownRow{any_name, "{date}{join}{minute}{until}"},
    KnownRow{any_name, "%Y%m%d%H%M"},
    KnownRow{any_name, "{camera}{gap}{date}{join}{clock}{fraction}{zone}", local, below},
    KnownRow{any_name, "{camera}{gap}{date}T{clock}%z", local, below},
    KnownRow{any_name, "{camera}{gap}{moment}{more}", local, below},
    KnownRow{any_name, "{camera}{gap}{date}{join}{minute}{until}", local, below},
    KnownRow{any_name, "{camera}{gap}%Y%m%d%H%M", local, below},
    KnownRow{any_name, "{before}{date}{join}{clock}{fraction}{zone}"},
    KnownRow{any_name, "{before}{moment}{more}"},
    // The date in folders, the time in the name.
    KnownRow{any_folder, "{dated}/{hour}/{clock}{set off}"},
    KnownRow{any_folder, "{dated}/{hour}/{camera}/{clock}{set off}", local, folder},
    KnownRow{any_folder, "{dated}/{named}/{hour}/{clock}{set off}", local, folder},
    KnownRow{any_folder, "{dated}/{hour}/%M"},
    KnownRow{any_folder, "{dated}/{hour}/%Mm"},
    KnownRow{any_folder, "{dated}/{hour}h/%M"},
    KnownRow{any_folder, "{dated}/{hour}/{named}/%M", local, folder},
    KnownRow{any_folder, "{dated}/{named}/{hour}/%M", local, folder},
    KnownRow{any_folder, "{dated}/{hour}/%M?%S", local, NamedCamera::whole, Ambiguity::repeated_hour},
    KnownRow{any_folder, "{dated}/{hour}/%Mm%Ss"},
    KnownRow{any_folder, "{dated}/{hour}/{named}/%M?%S", local, folder, Ambiguity::repeated_hour},
    KnownRow{any_folder, "{dated}/{named}/{hour}/%M?%S", local, folder, Ambiguity::repeated_hour},
    KnownRow{any_folder, "{dated}/{hour}/{minute}{until}"},
    KnownRow{any_folder, "{date}{join}{hour}/%M"},
    KnownRow{any_folder, "{date}{join}{hour}/%M?%S", local, NamedCamera::whole, Ambiguity::repeated_hour},
    KnownRow{any_folder, "{dated}/{clock}{gap}{side}", local, below},
    KnownRow{any_folder, "{dated}/{clock}{set off}"},
    KnownRow{any_folder, "{dated}/{minute}{until}"},
    KnownRow{any_folder, "{dated}/{camera}/{clock}{set off}", local, folder},
    KnownRow{any_folder, "{dated}/{named}/{minute}{until}", local, folder},
    KnownRow{any_folder, "{dated}/{camera}{gap}{time}{set off}", local, below},
    KnownRow{any_epoch, "{epoch}{until epoch}"},
    KnownRow{any_epoch, "{epoch ms}{until epoch}"},
    KnownRow{any_epoch, "{camera}{gap}{epoch}{until epoch}", local, below},
    KnownRow{any_epoch, "{camera}{gap}{epoch ms}{until epoch}", local, below},
};

/// A file with a number before the time.
struct NumberedFile {
    std::int64_t begin = 0;
    std::string name;
};

/// Whether the numbers of files are cameras: at least half of the files have a number that others have too, or begin
/// with a file of another number. A count of files does neither.
bool are_of_cameras(std::vector<NumberedFile> files) {
    constexpr std::int64_t together = 1;  // seconds
    std::ranges::sort(files, {}, &NumberedFile::begin);
    std::map<std::string_view, int> files_of;
    for (const NumberedFile& file : files) ++files_of[file.name];
    const auto is_parallel = [&](std::size_t a, std::size_t b) {
        return b < files.size() && files[b].begin - files[a].begin <= together && files[a].name != files[b].name;
    };
    std::size_t telling = 0;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const bool parallel = is_parallel(i, i + 1) || (i > 0 && is_parallel(i - 1, i));
        telling += parallel || files_of[files[i].name] > 1 ? 1 : 0;
    }
    return 2 * telling >= files.size();
}

constexpr std::string_view given_by_user = "--names";

/// Without ".mp4", but with the ".07" of "08.00.07".
std::string_view without_extension(std::string_view path) {
    const auto dot = path.rfind('.');
    const auto slash = path.rfind('/');
    if (dot == std::string_view::npos || (slash != std::string_view::npos && dot < slash)) return path;
    const std::string_view ending = path.substr(dot + 1);
    const bool number = ending.size() <= 2 && std::ranges::all_of(ending, is_digit);
    return number ? path : path.substr(0, dot);
}

bool is_ambiguous(const NameFields& name, Ambiguity doubt) {
    switch (doubt) {
        case Ambiguity::none:
            return false;
        case Ambiguity::day_or_month:
            return name[NameField::day] <= 12 && name[NameField::day] != name[NameField::month];
        case Ambiguity::repeated_hour:
            return name[NameField::hour] == name[NameField::minute];
        case Ambiguity::always:
            return true;
    }
    return true;
}

}  // namespace

std::int64_t utc_of(const NamedTime& time, std::optional<std::int64_t> near) {
    return time.ahead ? time.clock - *time.ahead : utc_of_local(time.clock, near);
}

NamingScheme::NamingScheme(std::string_view name, std::string_view pattern, bool utc)
    : name_(name), pattern_(pattern), utc_(utc) {}

NamingScheme::NamingScheme(std::string_view name, RecorderPattern pattern, bool utc, Ambiguity doubt,
                           NamedCamera camera)
    : name_(name), pattern_(std::move(pattern)), utc_(utc), ambiguity_(doubt), camera_(camera) {}

std::optional<RecorderName> NamingScheme::read(std::string_view path) const {
    const std::string_view stem = without_extension(path);
    auto name = read_stem(stem);
    return name || stem.size() == path.size() ? name : read_stem(path);
}

std::optional<RecorderName> NamingScheme::read_stem(std::string_view stem) const {
    std::optional<NameFields> fields = pattern_.read(stem);
    if (!fields) return std::nullopt;
    const bool own = name_ != given_by_user;
    if (own && fields->contradicts) return std::nullopt;
    RecorderName name{name_, std::move(fields->camera), camera_ != NamedCamera::whole};
    const bool counts = camera_ == NamedCamera::folder && std::ranges::all_of(name.camera, is_digit);
    if (name.below && !counts && is_generic_name(name.camera)) {
        if (std::ranges::any_of(name.camera, is_digit)) name.numbered = name.camera;
        name.camera.clear();
    }
    if (is_ambiguous(*fields, ambiguity_)) {
        name.ambiguous = true;
        return name;
    }
    name.begin = fields->time(utc_);
    const bool timed = (*fields)[NameField::hour] || (*fields)[NameField::epoch] || (*fields)[NameField::epoch_ms];
    if (timed && !name.begin) return std::nullopt;  // such as February 31
    return name;
}

/// The schemes of the known recorders. Most match no name, so all are tried in one pass.
class KnownSchemes {
  public:
    static const KnownSchemes& get() {
        static const KnownSchemes schemes;
        return schemes;
    }

    /// Adds those that may match a path, in the order of the table.
    void add_candidates(std::string_view path, std::vector<const NamingScheme*>& to) const {
        std::set<std::size_t> candidates;
        for (const std::string_view text : {path, without_extension(path)}) {
            const std::vector<std::size_t> found = set_.matching(text);
            candidates.insert(found.begin(), found.end());
        }
        for (const std::size_t candidate : candidates) to.push_back(&scheme(candidate));
    }

  private:
    KnownSchemes() : set_(loose_expressions()) {}

    static std::vector<std::string> loose_expressions() {
        std::vector<std::string> expressions;
        for (const KnownRow& row : known) expressions.push_back(RecorderPattern::loose_expression(row.pattern));
        return expressions;
    }

    /// Compiled when a name may match it. Compiling all of them would cost each run about 15 ms.
    const NamingScheme& scheme(std::size_t index) const {
        std::call_once(compiled_[index], [&] {
            const KnownRow& row = known[index];
            schemes_[index] =
                NamingScheme(row.recorder, RecorderPattern(row.pattern, RecorderPattern::Words::fields_and_own),
                             row.zone == Zone::utc, row.doubt, row.camera);
        });
        return *schemes_[index];
    }

    mutable std::array<std::once_flag, known.size()> compiled_;
    mutable std::array<std::optional<NamingScheme>, known.size()> schemes_;
    PatternSet set_;
};

namespace {

std::vector<const NamingScheme*> pointers_to(const std::vector<NamingScheme>& schemes) {
    std::vector<const NamingScheme*> pointers;
    for (const NamingScheme& scheme : schemes) pointers.push_back(&scheme);
    return pointers;
}

}  // namespace

RecorderNames::RecorderNames(std::span<const std::string> patterns, const std::filesystem::path& base) {
    for (const std::string& pattern : patterns) own_.emplace_back(given_by_user, pattern);
    if (base.empty()) return;
    std::error_code none;
    folder_ = std::filesystem::absolute(base, none).lexically_normal().string();
    if (!folder_.ends_with('/')) folder_ += '/';
}

std::string RecorderNames::whole(std::string_view path) const {
    return folder_ + std::string(path);
}

void RecorderNames::describe_camera(const std::string& camera, std::span<const std::string> patterns) {
    std::vector<NamingScheme>& schemes = of_cameras_[camera];
    for (const std::string& pattern : patterns) schemes.emplace_back(given_by_user, pattern);
}

RecorderName RecorderNames::read(std::string_view path) const {
    const std::string all = whole(path);
    RecorderName name = read_whole(all);
    if (of_cameras_.empty()) return name;
    std::vector<std::string> cameras;
    for (const auto& [camera, schemes] : of_cameras_) cameras.push_back(camera);
    const auto own = of_cameras_.find(name_of_camera(camera_of(name, all, 0), cameras));
    if (own == of_cameras_.end()) return name;
    RecorderName described = read_with(all, pointers_to(own->second));
    if (!described.begin) return name;
    described.camera = std::move(name.camera);
    described.below = name.below;
    return described;
}

/// The user's schemes come before those of known recorders.
RecorderName RecorderNames::read_whole(std::string_view whole_path) const {
    std::vector<const NamingScheme*> schemes = pointers_to(own_);
    KnownSchemes::get().add_candidates(whole_path, schemes);
    return read_with(whole_path, schemes);
}

RecorderName RecorderNames::read_with(std::string_view whole_path, std::span<const NamingScheme* const> schemes) const {
    RecorderName name;
    for (const NamingScheme* const scheme : schemes) {
        std::optional<RecorderName> read = scheme->read(whole_path);
        if (!read) continue;
        if (name.layout.empty()) name.layout = std::move(read->layout);
        if (name.camera.empty()) {
            name.camera = std::move(read->camera);
            name.below = read->below;
            name.numbered = std::move(read->numbered);
        }
        name.begin = read->begin;
        name.ambiguous = read->ambiguous;
        // A pattern without a time leaves the time to later patterns.
        if (name.begin || name.ambiguous) break;
    }
    const bool is_camera = !name.numbered.empty() && (of_cameras_.contains(name.numbered) ||
                                                      numbered_.contains(numbered_with(whole_path, name.numbered)));
    if (name.camera.empty() && is_camera) name.camera = name.numbered;
    return name;
}

void RecorderNames::find_numbered_cameras(std::span<const std::string> paths) {
    std::map<std::string, std::vector<NumberedFile>> files_by_key;
    for (const std::string& path : paths) {
        const std::string all = whole(path);
        RecorderName name = read_whole(all);
        if (name.numbered.empty() || !name.begin) continue;
        files_by_key[numbered_with(all, name.numbered)].push_back({name.begin->clock, std::move(name.numbered)});
    }
    for (auto& [key, files] : files_by_key) {
        if (are_of_cameras(std::move(files))) numbered_.insert(key);
    }
}

std::string RecorderNames::camera_of(std::string_view path, std::size_t skipped) const {
    const std::string all = whole(path);
    return camera_of(read_whole(all), all, skipped);
}

std::string RecorderNames::camera_of(const RecorderName& name, std::string_view whole_path, std::size_t skipped) const {
    if (!name.camera.empty() && !name.below) return name.camera;
    std::string folders = camera_of_folders(whole_path, folder_.size() + skipped);
    if (name.camera.empty() || folders == name.camera || folders.ends_with('/' + name.camera)) return folders;
    if (folders.empty() || is_generic_name(folders)) return name.camera;
    return folders + '/' + name.camera;
}

std::string name_of_camera(std::string_view camera, std::span<const std::string> names) {
    std::string best;
    for (const std::string& name : names) {
        const bool means = camera == name || camera.ends_with('/' + name);
        if (means && name.size() > best.size()) best = name;
    }
    return best;
}

std::vector<std::string> known_recorders() {
    std::vector<std::string> names;
    for (const KnownRow& row : known) {
        if (!row.recorder.empty() && std::ranges::count(names, row.recorder) == 0) names.emplace_back(row.recorder);
    }
    return names;
}

}  // namespace vvr::video
