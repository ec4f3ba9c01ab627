#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <string_view>

// The kinds of events. This table is all that pictures, pages, reports and archives know of a kind; conclude.cpp
// decides which kind an object is.
namespace vvr::tracking {

enum class EventKind {
    moved,    ///< it moved through the scene
    stood,    ///< it moved, and stayed in its place for a while
    left,     ///< somebody put it down
    taken,    ///< it belonged to the empty scene, and was removed
    changed,  ///< somebody changed the place; whether a thing came or went is not certain
};

/// How a kind's badge stands out on pages.
enum class Emphasis { none, standing, strong };

/// What an archive's index says of a clip's events of a kind.
enum class Tally {
    none,
    lasts,  ///< duration of the longest
    still,  ///< longest time for which one stayed, in all its stays
    count,
};

/// A filter of an archive's index: the clips with events of some kinds.
struct KindChoice {
    std::string_view name;   ///< in the index's URL
    std::string_view words;  ///< on its button
    std::string_view order;  ///< label of the sort order
};
inline constexpr KindChoice choice_of_things{"left", "Left behind", "longest left behind first"};
inline constexpr KindChoice choice_of_standing{"stood", "Stayed", "longest stay first"};

/// One row of the table of kinds.
struct EventKindRow {
    EventKind kind;
    std::string_view name;  ///< in options, reports, sidecars
    std::string_view help;
    std::string_view words;     ///< on pages
    std::string_view activity;  ///< in pictures; `{}` = how long it stayed; empty = the picture shows where it went
    std::string_view activity_short;
    std::string_view by;                 ///< on pages: what the event `by` did; empty = there is none
    int rank = 0;                        ///< 0 = most important to a reader
    bool is_thing = false;               ///< it was put down or taken: lists show it first, time strips mark it
    bool lies = false;                   ///< it keeps its place all the time
    bool is_of_scene = false;            ///< the empty scene shows it best
    Emphasis emphasis = Emphasis::none;  ///< of its badge
    Tally tally = Tally::none;
    const KindChoice* choice = nullptr;  ///< the index's filter that selects it
};

/// The kinds, in the order of EventKind.
inline constexpr std::array event_kinds{
    EventKindRow{.kind = EventKind::moved,
                 .name = "moved",
                 .help = "went through the scene",
                 .words = "moved",
                 .activity = "",
                 .activity_short = "",
                 .by = "",
                 .rank = 4},
    EventKindRow{.kind = EventKind::stood,
                 .name = "stood",
                 .help = "kept its place for a while",
                 .words = "stayed",
                 .activity = "stayed {}",
                 .activity_short = "stayed",
                 .by = "",
                 .rank = 3,
                 .emphasis = Emphasis::standing,
                 .tally = Tally::still,
                 .choice = &choice_of_standing},
    EventKindRow{.kind = EventKind::left,
                 .name = "left",
                 .help = "was put down",
                 .words = "left behind",
                 .activity = "left behind",
                 .activity_short = "left",
                 .by = "put down by",
                 .rank = 0,
                 .is_thing = true,
                 .lies = true,
                 .emphasis = Emphasis::strong,
                 .tally = Tally::lasts,
                 .choice = &choice_of_things},
    EventKindRow{.kind = EventKind::taken,
                 .name = "taken",
                 .help = "belonged to the empty scene, and went",
                 .words = "taken",
                 .activity = "taken away",
                 .activity_short = "taken",
                 .by = "taken by",
                 .rank = 1,
                 .is_thing = true,
                 .is_of_scene = true,
                 .emphasis = Emphasis::strong,
                 .tally = Tally::count,
                 .choice = &choice_of_things},
    EventKindRow{.kind = EventKind::changed,
                 .name = "changed",
                 .help = "a place that somebody changed; whether a thing came or went is not certain",
                 .words = "changed",
                 .activity = "changed here",
                 .activity_short = "changed",
                 .by = "changed by",
                 .rank = 2,
                 .is_thing = true,
                 .lies = true,
                 .emphasis = Emphasis::standing,
                 .tally = Tally::count,
                 .choice = &choice_of_things},
};

constexpr bool kinds_are_in_order() {
    std::array<bool, event_kinds.size()> ranks{};
    for (std::size_t k = 0; k < event_kinds.size(); ++k) {
        if (event_kinds[k].kind != static_cast<EventKind>(k)) return false;
        ranks.at(static_cast<std::size_t>(event_kinds[k].rank)) = true;
    }
    return std::ranges::all_of(ranks, [](bool taken) { return taken; });
}
static_assert(kinds_are_in_order(), "the rows are in the order of EventKind, and each has a rank of its own");

constexpr const EventKindRow& row_of(EventKind kind) {
    return event_kinds.at(static_cast<std::size_t>(kind));
}

/// "moved", "stood", …
constexpr std::string_view name_of(EventKind kind) {
    return row_of(kind).name;
}

/// The most important to a reader come first.
constexpr auto ranked_kinds() {
    auto ranked = event_kinds;
    std::ranges::sort(ranked, {}, &EventKindRow::rank);
    return ranked;
}

inline std::set<EventKind> all_kinds() {
    std::set<EventKind> kinds;
    for (const EventKindRow& row : event_kinds) kinds.insert(row.kind);
    return kinds;
}

}  // namespace vvr::tracking
