#include "cli/app/told_events.h"

#include <map>
#include <optional>

#include "core/events/colouring.h"

namespace vvr::app {

ToldEvents told_in(std::span<const events::Event> events, double begin, double end) {
    ToldEvents told;
    const std::vector<int> colours = events::colours_of(events);
    std::map<std::size_t, std::size_t> places;  // of those that are told
    for (std::size_t k = 0; k < events.size(); ++k) {
        if (events[k].last.seconds < begin || events[k].first.seconds > end) continue;
        places[k] = told.events.size();
        events::Event& event = told.events.emplace_back(events[k]);
        std::erase_if(event.path, [&](const events::PathPoint& point) {
            return point.at.seconds < begin || point.at.seconds > end;
        });
        told.numbers.push_back(k + 1);
        told.colours.push_back(colours[k]);
    }
    for (events::Event& event : told.events) {
        for (std::optional<std::size_t>* const other : {&event.from, &event.into, &event.by}) {
            const auto place = *other ? places.find(**other) : places.end();
            *other = place == places.end() ? std::nullopt : std::optional(place->second);
        }
    }
    return told;
}

}  // namespace vvr::app
