#include "core/page/stills.h"

#include <utility>

#include "core/image/resized.h"

namespace vvr::page {

void Stills::add(std::int64_t frame, double seconds, const Plane<Bgr>& picture, std::int64_t activity) {
    if (kept_.empty() || in_last_ == stretch_) {
        if (kept_.size() == most_) merge_neighbours();
        kept_.push_back({{frame, seconds, image::resized(picture, size_)}, activity});
        in_last_ = 1;
        return;
    }
    ++in_last_;
    Kept& last = kept_.back();
    if (activity > last.activity) last = {{frame, seconds, image::resized(picture, size_)}, activity};
}

std::vector<Still> Stills::take() {
    std::vector<Still> stills;
    stills.reserve(kept_.size());
    for (Kept& kept : kept_) stills.push_back(std::move(kept.still));
    kept_.clear();
    return stills;
}

void Stills::merge_neighbours() {
    for (std::size_t k = 0; k < most_ / 2; ++k) {
        Kept& a = kept_[2 * k];
        Kept& b = kept_[2 * k + 1];
        Kept better = std::move(b.activity > a.activity ? b : a);
        kept_[k] = std::move(better);
    }
    kept_.resize(most_ / 2);
    stretch_ *= 2;
}

}  // namespace vvr::page
