#include "core/archive/need.h"

#include <algorithm>
#include <array>
#include <system_error>

#include "core/archive/pieces.h"

namespace vvr::archive {

namespace {

struct NeedRow {
    Need need;
    std::string_view name;
    bool work;
};

constexpr std::array rows{
    NeedRow{Need::nothing, "done", false},         NeedRow{Need::added, "new", true},
    NeedRow{Need::changed, "changed", true},       NeedRow{Need::settings, "other settings", true},
    NeedRow{Need::missing, "files missing", true}, NeedRow{Need::retry, "failed, again", true},
    NeedRow{Need::given_up, "given up", false},    NeedRow{Need::still_written, "still written", false},
    NeedRow{Need::expired, "too old", false},      NeedRow{Need::later, "later", false},
    NeedRow{Need::unread, "unreadable", false},    NeedRow{Need::outside, "outside", false},
};

const NeedRow& row_of(Need need) {
    return *std::ranges::find(rows, need, &NeedRow::need);
}

bool files_there(const Sidecar& sidecar, const std::filesystem::path& out, const ArchiveRules& rules) {
    if (!has_pieces(pieces_folder(out, sidecar.clip.path), sidecar.pieces)) return false;
    return std::ranges::all_of(rules.files, [&](OutputKind kind) {
        std::error_code none;
        return std::ranges::count(sidecar.files, kind) > 0 &&
               std::filesystem::is_regular_file(output_path(out, sidecar.clip.path, kind), none);
    });
}

/// Whether a clip failed for lack of memory more than a day ago: the machine may have been short of it, not the clip
/// too large. The kernel ends a worker by SIGKILL then.
bool may_have_memory_now(const Sidecar& sidecar, const std::filesystem::path& out) {
    constexpr int by_sigkill = 137;
    std::error_code error;
    const auto tried = std::filesystem::last_write_time(sidecar_path(out, sidecar.clip.path), error);
    return (sidecar.code == ErrorCode::out_of_memory || sidecar.status == by_sigkill) && !error &&
           tried < std::filesystem::file_time_type::clock::now() - std::chrono::days(1);
}

Need need_by_sidecar(const Clip& clip, const std::optional<Sidecar>& sidecar, const std::filesystem::path& out,
                     const ArchiveRules& rules) {
    if (!sidecar) return Need::added;
    if (sidecar->clip.size != clip.size || sidecar->clip.modified != clip.modified) return Need::changed;
    if (sidecar->settings != rules.settings) return Need::settings;
    if (sidecar->state == Sidecar::State::outside) return Need::outside;
    if (sidecar->state == Sidecar::State::done) {
        if (!files_there(*sidecar, out, rules)) return Need::missing;
        return lacks_pieces(*sidecar) && sidecar->tries < rules.tries ? Need::retry : Need::nothing;
    }
    // Another version may succeed, and so may a worker that may use more.
    const bool again = sidecar->tries < rules.tries || sidecar->version != rules.version ||
                       is_limit_raised(*sidecar, rules.limits) || may_have_memory_now(*sidecar, out);
    return again ? Need::retry : Need::given_up;
}

}  // namespace

Need need_of(const Clip& clip, const std::optional<Sidecar>& sidecar, const std::filesystem::path& out,
             const ArchiveRules& rules, std::chrono::system_clock::time_point now) {
    const Need need = need_by_sidecar(clip, sidecar, out, rules);
    if (!wants_work(need)) return need;
    if (is_expired(clip, rules, now)) return Need::expired;
    return Settling{now, rules.settle}.waits_for(clip) ? Need::still_written : need;
}

Need need_of_day(const Clip& day, const std::optional<Sidecar>& sidecar, const std::filesystem::path& out,
                 const ArchiveRules& rules, std::chrono::system_clock::time_point now) {
    const Need need = need_of(day, sidecar, out, rules, now);
    const bool begins_elsewhere = sidecar && sidecar->day && sidecar->day->rule != rules.day;
    if (begins_elsewhere && !is_expired(day, rules, now) && (need == Need::nothing || need == Need::changed))
        return Need::settings;
    if (need != Need::changed || sidecar->settings != rules.settings || !files_there(*sidecar, out, rules)) return need;
    // The recorder removes its oldest files; the picture still shows them.
    const bool fewer = day.modified <= sidecar->clip.modified && day.size < sidecar->clip.size;
    if (fewer && sidecar->state == Sidecar::State::done) return Need::nothing;
    const std::chrono::nanoseconds added{day.modified - sidecar->clip.modified};
    const std::chrono::system_clock::time_point modified{std::chrono::nanoseconds(day.modified)};
    const bool is_past = modified <= now;  // false if a clock is ahead: then waiting is pointless
    const bool waits =
        is_past && added >= std::chrono::nanoseconds(0) && added < rules.redraw && modified > now - rules.redraw;
    return waits ? Need::later : need;
}

bool is_expired(const Clip& clip, const ArchiveRules& rules, std::chrono::system_clock::time_point now) {
    const std::chrono::system_clock::time_point modified{std::chrono::nanoseconds(clip.modified)};
    return rules.keep && modified < now - *rules.keep;
}

bool wants_work(Need need) {
    return row_of(need).work;
}

std::string_view name_of(Need need) {
    return row_of(need).name;
}

}  // namespace vvr::archive
