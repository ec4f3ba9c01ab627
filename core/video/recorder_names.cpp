#include "core/video/recorder_names.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/choice.h"
#include "core/error.h"
#include "core/local_time.h"

namespace vvr {

namespace {

/// What a part of a pattern stands for.
enum class Meaning { any, one, camera, number, year, year_of_century, month, day, hour, minute, second, epoch, zone };

struct FieldRow {
    std::string_view name;
    Meaning meaning;
    std::size_t least = 0;  ///< digits
    std::size_t most = 0;
    std::int64_t low = 0;
    std::int64_t high = 0;
};

constexpr std::int64_t no_limit = std::numeric_limits<std::int64_t>::max();

constexpr std::array fields{
    FieldRow{"*", Meaning::any},
    FieldRow{"?", Meaning::one},
    FieldRow{"{camera}", Meaning::camera},
    FieldRow{"{number}", Meaning::number, 1, 18, 0, no_limit},
    FieldRow{"%Y", Meaning::year, 4, 4, 1970, 2199},
    FieldRow{"%y", Meaning::year_of_century, 2, 2, 0, 99},
    FieldRow{"%m", Meaning::month, 2, 2, 1, 12},
    FieldRow{"%-m", Meaning::month, 1, 2, 1, 12},
    FieldRow{"%d", Meaning::day, 2, 2, 1, 31},
    FieldRow{"%-d", Meaning::day, 1, 2, 1, 31},
    FieldRow{"%H", Meaning::hour, 2, 2, 0, 23},
    FieldRow{"%-H", Meaning::hour, 1, 2, 0, 23},
    FieldRow{"%M", Meaning::minute, 2, 2, 0, 59},
    FieldRow{"%S", Meaning::second, 2, 2, 0, 60},
    FieldRow{"%s", Meaning::epoch, 9, 11, 0, no_limit},
    FieldRow{"%z", Meaning::zone},
};

struct KnownRow {
    std::string_view recorder;
    std::string_view pattern;
    bool utc = false;
};

// Those with more text of their own come first, as the last ones match many names.
constexpr std::array known{
    KnownRow{"Frigate", "%Y-%m-%d/%H/{camera}/%M.%S", true},
    KnownRow{"Frigate", "%Y-%m/%d/%H/{camera}/%M.%S"},  // before its version 0.12
    KnownRow{"Dahua", "%Y-%m-%d/{number}/dav/%H/%H.%M.%S-*"},
    KnownRow{"Dahua", "{camera}_main_%Y%m%d%H%M%S_*"},
    KnownRow{"Dahua", "{camera}_sub_%Y%m%d%H%M%S_*"},
    KnownRow{"Hikvision", "{camera}_hiknvr_%Y%m%d%H%M%S_*"},
    KnownRow{"Reolink", "{camera}_{number}_%Y%m%d%H%M%S"},
    KnownRow{"Reolink", "Rec*%Y%m%d_%H%M%S_*"},  // on the camera's own card
    KnownRow{"Hikvision", "{camera}_{number}_%Y%m%d%H%M%S*"},
    KnownRow{"Blue Iris", "{camera}.%Y%m%d_%H%M%S*"},
    KnownRow{"UniFi", "{camera} %-m-%-d-%Y, %-H.%M.%S GMT%z*"},
    KnownRow{"UniFi", "{camera} %-m-%-d-%Y, %-H.%M.%S*"},
    KnownRow{"motion", "{number}-%Y%m%d%H%M%S"},
    KnownRow{"motion", "%Y-%m-%d/%H-%M-%S"},  // motionEye
    KnownRow{"ISO 8601", "*%Y-%m-%d?%H?%M?%S%z"},
    KnownRow{"ISO 8601", "*%Y%m%dT%H%M%S%z"},
    KnownRow{"ISO 8601", "*%Y-%m-%d?%H?%M?%S*"},
    KnownRow{"ISO 8601", "*%Y%m%d?%H%M%S*"},
    KnownRow{"ISO 8601", "*%Y%m%d%H%M%S*"},
};

constexpr std::string_view given_by_user = "--names";
constexpr std::size_t longest_pattern = 255;
constexpr std::size_t longest_path = 4096;

const FieldRow& row_of(std::string_view field) {
    return *std::ranges::find(fields, field, &FieldRow::name);
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

std::size_t digits_at(std::string_view text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && is_digit(text[end])) ++end;
    return end - at;
}

std::int64_t number_in(std::string_view digits) {
    std::int64_t value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

/// A zone as names have it, "Z", "+1", "+01:00", "-0330": how many characters it takes, and seconds ahead of UTC.
struct ZoneText {
    std::size_t length = 0;
    std::int64_t ahead = 0;
};

std::optional<ZoneText> zone_at(std::string_view text) {
    if (text.starts_with('Z')) return ZoneText{1, 0};
    if (!text.starts_with('+') && !text.starts_with('-')) return std::nullopt;
    const std::size_t count = digits_at(text, 1);
    if (count < 1 || count == 3 || count > 4) return std::nullopt;
    const std::size_t hours = std::min<std::size_t>(count, 2);
    const std::int64_t hour = number_in(text.substr(1, hours));
    std::size_t length = 1 + count;
    std::int64_t minute = count == 4 ? number_in(text.substr(3, 2)) : 0;
    if (count <= 2 && length < text.size() && text[length] == ':' && digits_at(text, length + 1) == 2) {
        minute = number_in(text.substr(length + 1, 2));
        length += 3;
    }
    if (hour > 14 || minute > 59) return std::nullopt;
    const std::int64_t ahead = hour * 3600 + minute * 60;
    return ZoneText{length, text.front() == '-' ? -ahead : ahead};
}

/// 2026, 2026-11, 20261121, 2026_11_21: a year, then only numbers.
bool is_date(std::string_view folder) {
    const bool year = folder.size() >= 4 && (folder.starts_with("19") || folder.starts_with("20")) &&
                      std::ranges::all_of(folder.substr(0, 4), is_digit);
    if (!year || folder.size() == 5 || folder.size() > 10) return false;
    return std::ranges::all_of(folder.substr(4),
                               [](char c) { return is_digit(c) || c == '-' || c == '_' || c == '.'; });
}

/// What stands in folders below a date: month, day, hour.
bool is_part_of_date(std::string_view folder) {
    return is_date(folder) || (folder.size() <= 2 && std::ranges::all_of(folder, is_digit));
}

std::string camera_of_folders(std::string_view path) {
    std::string camera;
    bool dated = false;
    for (auto slash = path.find('/'); slash != std::string_view::npos; slash = path.find('/')) {
        const std::string_view folder = path.substr(0, slash);
        path.remove_prefix(slash + 1);
        if (dated && is_part_of_date(folder)) continue;
        if (dated) return std::string(folder);
        if (is_date(folder)) {
            if (!camera.empty()) return camera;
            dated = true;
            continue;
        }
        if (!camera.empty()) camera += '/';
        camera += folder;
    }
    return camera;
}

/// The last folders of a path, and its name; nothing where it has fewer.
std::optional<std::string_view> last_folders(std::string_view path, std::size_t count) {
    std::size_t begin = path.size();
    for (std::size_t k = 0; k <= count; ++k) {
        if (begin == 0) return std::nullopt;
        const auto slash = path.rfind('/', begin - 1);
        if (slash == std::string_view::npos) return k == count ? std::optional(path) : std::nullopt;
        begin = slash;
    }
    return path.substr(begin + 1);
}

std::string_view without_ending(std::string_view path) {
    const auto dot = path.rfind('.');
    const auto slash = path.rfind('/');
    return dot == std::string_view::npos || (slash != std::string_view::npos && dot < slash) ? path
                                                                                             : path.substr(0, dot);
}

}  // namespace

/// Matches one path against the parts of a layout. Where a place in the path has failed for a part once, it is not
/// tried again, so that no name takes long.
class RecorderLayout::Match {
  public:
    Match(const std::vector<Part>& parts, std::string_view path)
        : parts_(parts), path_(path), failed_(parts.size() * (path.size() + 1)) {}

    bool run() { return from(0, 0); }

    std::string camera;
    std::array<std::int64_t, fields.size()> values{};  ///< by Meaning
    std::array<bool, fields.size()> found{};

  private:
    bool from(std::size_t part, std::size_t at) {
        if (part == parts_.size()) return at == path_.size();
        if (failed_[place(part, at)]) return false;
        if (here(part, at)) return true;
        failed_[place(part, at)] = true;
        return false;
    }

    std::size_t place(std::size_t part, std::size_t at) const { return part * (path_.size() + 1) + at; }

    bool here(std::size_t part, std::size_t at) {
        const Part& what = parts_[part];
        if (what.field.empty()) {
            return path_.substr(at).starts_with(what.text) && from(part + 1, at + what.text.size());
        }
        const FieldRow& field = row_of(what.field);
        switch (field.meaning) {
            case Meaning::any:
                return text_from(part, at, at, nullptr);
            case Meaning::one:
                return at < path_.size() && path_[at] != '/' && from(part + 1, at + 1);
            case Meaning::camera:
                return text_from(part, at, at + 1, &camera);
            case Meaning::zone: {
                const auto zone = zone_at(path_.substr(at));
                return zone && from(part + 1, at + zone->length) && take(field, zone->ahead);
            }
            default:
                return number_from(field, part, at);
        }
    }

    /// Text without a `/`, as little of it as does. Where none does, none does from a later place before the `/`
    /// either.
    bool text_from(std::size_t part, std::size_t at, std::size_t end, std::string* text) {
        for (; end <= path_.size(); ++end) {
            if (end > at && path_[end - 1] == '/') break;
            if (from(part + 1, end)) {
                if (text != nullptr) *text = path_.substr(at, end - at);
                return true;
            }
            if (failed_[place(part, end)]) break;
        }
        for (std::size_t k = at; k < std::min(end, path_.size() + 1); ++k) failed_[place(part, k)] = true;
        return false;
    }

    bool number_from(const FieldRow& field, std::size_t part, std::size_t at) {
        for (std::size_t count = std::min(field.most, digits_at(path_, at)); count >= field.least; --count) {
            const std::int64_t value = number_in(path_.substr(at, count));
            if (value < field.low || value > field.high) continue;
            if (from(part + 1, at + count)) return take(field, value);
        }
        return false;
    }

    bool take(const FieldRow& field, std::int64_t value) {
        values[static_cast<std::size_t>(field.meaning)] = value;
        found[static_cast<std::size_t>(field.meaning)] = true;
        return true;
    }

    const std::vector<Part>& parts_;
    std::string_view path_;
    std::vector<bool> failed_;
};

namespace {

/// The time that was found; nothing when there is no such day.
template <class Match>
std::optional<NamedTime> time_in(const Match& match, bool utc) {
    const auto value = [&](Meaning meaning) { return match.values[static_cast<std::size_t>(meaning)]; };
    const auto found = [&](Meaning meaning) { return match.found[static_cast<std::size_t>(meaning)]; };
    if (found(Meaning::epoch)) return NamedTime{value(Meaning::epoch), 0};
    const bool century = found(Meaning::year_of_century);
    if (!found(Meaning::hour)) return std::nullopt;
    const std::int64_t year = century ? 2000 + value(Meaning::year_of_century) : value(Meaning::year);
    const std::chrono::year_month_day date{std::chrono::year(static_cast<int>(year)),
                                           std::chrono::month(static_cast<unsigned>(value(Meaning::month))),
                                           std::chrono::day(static_cast<unsigned>(value(Meaning::day)))};
    if (!date.ok()) return std::nullopt;
    const std::chrono::sys_seconds midnight = std::chrono::sys_days(date);
    NamedTime time{midnight.time_since_epoch().count() + value(Meaning::hour) * 3600 + value(Meaning::minute) * 60 +
                       value(Meaning::second),
                   {}};
    if (found(Meaning::zone)) {
        time.ahead = value(Meaning::zone);
    } else if (utc) {
        time.ahead = 0;
    }
    return time;
}

[[noreturn]] void refuse(std::string_view pattern, std::string_view why) {
    throw Error(ErrorKind::usage,
                fmt::format("'{}' is no pattern of names: {}; for example "
                            "'%Y-%m-%d/%H/{{camera}}/%M.%S' is Frigate's",
                            pattern, why),
                {"names"});
}

}  // namespace

std::int64_t utc_of(const NamedTime& time, std::optional<std::int64_t> near) {
    return time.ahead ? time.clock - *time.ahead : utc_of_local(time.clock, near);
}

RecorderLayout::RecorderLayout(std::string_view name, std::string_view pattern, bool utc) : name_(name), utc_(utc) {
    if (pattern.empty() || pattern.size() > longest_pattern) {
        refuse(pattern, fmt::format("it has {} bytes where 1 to {} are possible", pattern.size(), longest_pattern));
    }
    folders_ = static_cast<std::size_t>(std::ranges::count(pattern, '/'));
    std::array<bool, fields.size()> has{};
    for (std::string_view rest = pattern; !rest.empty();) {
        const auto field =
            std::ranges::find_if(fields, [&](const FieldRow& row) { return rest.starts_with(row.name); });
        if (field != fields.end()) {
            parts_.push_back({field->name});
            has[static_cast<std::size_t>(field->meaning)] = true;
            rest.remove_prefix(field->name.size());
            continue;
        }
        const bool percent = rest.starts_with("%%");
        if (!percent && (rest.front() == '%' || rest.front() == '{')) {
            const std::size_t end = rest.front() == '%' ? 2 : std::min(rest.find('}'), rest.size() - 1) + 1;
            refuse(pattern, fmt::format("it has '{}', and fields are {}", rest.substr(0, end),
                                        fmt::join(names_of(fields), " ")));
        }
        if (parts_.empty() || !parts_.back().field.empty()) parts_.push_back({});
        parts_.back().text += rest.front();
        rest.remove_prefix(percent ? 2 : 1);
    }
    const auto is_there = [&](Meaning meaning) { return has[static_cast<std::size_t>(meaning)]; };
    const bool day = (is_there(Meaning::year) || is_there(Meaning::year_of_century)) && is_there(Meaning::month) &&
                     is_there(Meaning::day);
    const bool partly = day || is_there(Meaning::hour) || is_there(Meaning::month) || is_there(Meaning::day);
    const bool whole = is_there(Meaning::epoch) || (day && is_there(Meaning::hour));
    if (partly && !whole) refuse(pattern, "a time needs %Y, %m, %d and %H, or %s");
    if (!whole && !is_there(Meaning::camera)) refuse(pattern, "it has neither {camera} nor a time");
}

std::optional<RecorderName> RecorderLayout::read(std::string_view path) const {
    if (path.size() > longest_path) return std::nullopt;
    for (const std::string_view stem : {without_ending(path), path}) {
        const auto end = last_folders(stem, folders_);
        if (!end) return std::nullopt;
        Match match(parts_, *end);
        if (!match.run()) continue;
        const std::optional<NamedTime> time = time_in(match, utc_);
        const bool timed = match.found[static_cast<std::size_t>(Meaning::hour)] ||
                           match.found[static_cast<std::size_t>(Meaning::epoch)];
        if (timed && !time) continue;  // the 31st of February
        return RecorderName{name_, match.camera, time};
    }
    return std::nullopt;
}

RecorderNames::RecorderNames(std::span<const std::string> patterns) {
    for (const std::string& pattern : patterns) layouts_.emplace_back(given_by_user, pattern);
    for (const KnownRow& row : known) layouts_.emplace_back(row.recorder, row.pattern, row.utc);
}

RecorderName RecorderNames::read(std::string_view path) const {
    RecorderName name;
    for (const RecorderLayout& layout : layouts_) {
        std::optional<RecorderName> read = layout.read(path);
        if (!read) continue;
        if (name.layout.empty()) name.layout = std::move(read->layout);
        if (name.camera.empty()) name.camera = std::move(read->camera);
        if (!name.begin) name.begin = read->begin;
        // A pattern that tells the camera alone leaves the time to others.
        if (name.begin) break;
    }
    return name;
}

std::string RecorderNames::camera_of(std::string_view path) const {
    const RecorderName name = read(path);
    return name.camera.empty() ? camera_of_folders(path) : name.camera;
}

std::vector<std::string> known_recorders() {
    std::vector<std::string> names;
    for (const KnownRow& row : known) {
        if (std::ranges::count(names, row.recorder) == 0) names.emplace_back(row.recorder);
    }
    return names;
}

}  // namespace vvr
