#include <array>

#include "core/events/event.h"

namespace vvr::events {

namespace {

constexpr std::array rows{
    EventKindRow{EventKind::moved, "moved", "went through the scene"},
    EventKindRow{EventKind::stood, "stood", "kept its place for a while"},
    EventKindRow{EventKind::left, "left", "was put down"},
    EventKindRow{EventKind::taken, "taken", "belonged to the empty scene, and went"},
};

}  // namespace

std::span<const EventKindRow> event_kinds() {
    return rows;
}

std::string_view name_of(EventKind kind) {
    return rows[static_cast<std::size_t>(kind)].name;
}

double stationary_seconds(const Event& event) {
    double still = 0;
    for (const Stay& stay : event.stays) still += stay.last.seconds - stay.first.seconds;
    return still;
}

}  // namespace vvr::events
