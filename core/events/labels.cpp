#include "core/events/labels.h"

namespace vvr::events {

void add_runs(const Patch& patch, std::size_t track, FrameLabels& labels) {
    for (int j = 0; j < patch.box.height(); ++j) {
        int i = 0;
        while (i < patch.box.width()) {
            if (patch.values.at(i, j) == 0) {
                ++i;
                continue;
            }
            const int first = i;
            while (i < patch.box.width() && patch.values.at(i, j) != 0) ++i;
            labels.runs.push_back({patch.box.top + j, patch.box.left + first, patch.box.left + i, track});
        }
    }
}

std::vector<std::optional<std::size_t>> events_of_tracks(std::span<const Event> events) {
    std::vector<std::optional<std::size_t>> table;
    for (std::size_t place = 0; place < events.size(); ++place) {
        for (const std::size_t track : events[place].tracks) {
            if (track >= table.size()) table.resize(track + 1);
            table[track] = place;
        }
    }
    return table;
}

}  // namespace vvr::events
