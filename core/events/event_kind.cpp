#include <algorithm>
#include <array>

#include "core/events/event.h"

namespace vvr {

std::span<const EventKindRow> event_kinds() {
    static constexpr std::array rows{
        EventKindRow{"moved", "went through the scene", EventKind::moved},
        EventKindRow{"stood", "went through the scene and kept its place for a while", EventKind::stood},
        EventKindRow{"left", "was put down by somebody", EventKind::left},
        EventKindRow{"taken", "belonged to the empty scene and went", EventKind::taken},
    };
    return rows;
}

std::string_view name_of(EventKind kind) {
    return std::ranges::find(event_kinds(), kind, &EventKindRow::kind)->name;
}

}  // namespace vvr
