#include "core/events/event.h"

namespace vvr {

std::string_view name_of(EventKind kind) {
    switch (kind) {
        case EventKind::moved:
            return "moved";
        case EventKind::stood:
            return "stood";
        case EventKind::left:
            return "left";
        case EventKind::taken:
            return "taken";
    }
    return "";
}

}  // namespace vvr
