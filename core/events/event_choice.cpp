#include "core/events/event_choice.h"

#include <optional>
#include <utility>

namespace vvr::events {

std::vector<Event> choose_events(std::vector<Event> events, const EventChoice& choice) {
    std::vector<std::optional<std::size_t>> places(events.size());
    std::size_t count = 0;
    for (std::size_t k = 0; k < events.size(); ++k) {
        const double seconds = events[k].last.seconds - events[k].first.seconds;
        if (choice.kinds.contains(events[k].kind) && seconds >= choice.least) places[k] = count++;
    }
    std::vector<Event> chosen;
    chosen.reserve(count);
    for (std::size_t k = 0; k < events.size(); ++k) {
        if (!places[k]) continue;
        Event& event = chosen.emplace_back(std::move(events[k]));
        for (auto* other : {&event.from, &event.into, &event.by}) {
            if (*other) *other = places[**other];
        }
    }
    return chosen;
}

}  // namespace vvr::events
