#include "core/events/stays.h"

#include <algorithm>
#include <utility>

namespace vvr::events {

void Stays::add(const Moment& now, const glm::dvec2& place, const PixelBox& box, double reach) {
    if (open_ && glm::distance(place, open_->place) <= reach) {
        open_->last = now;
        return;
    }
    close();
    open_ = Stay{now, now, place, box};
}

void Stays::add_exactly(const Stay& stay) {
    open_.reset();
    std::erase_if(found_, [&](const Stay& other) { return other.last.frame >= stay.first.frame; });
    found_.push_back(stay);
}

std::vector<Stay> Stays::finish() {
    close();
    return std::move(found_);
}

void Stays::close() {
    if (open_ && open_->last.seconds - open_->first.seconds >= least_) found_.push_back(*open_);
    open_.reset();
}

}  // namespace vvr::events
