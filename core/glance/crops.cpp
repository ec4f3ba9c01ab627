#include "core/glance/crops.h"

#include <algorithm>

#include "core/image/resized.h"

namespace vvr::glance {

namespace {

Plane<Bgr> cut_out(const Plane<Bgr>& from, const PixelBox& box) {
    Plane<Bgr> part(box.size());
    for (int j = 0; j < box.height(); ++j) {
        const auto row = from.row(box.top + j).subspan(static_cast<std::size_t>(box.left), part.row(j).size());
        std::ranges::copy(row, part.row(j).begin());
    }
    return part;
}

}  // namespace

PixelBox still_box(const PixelBox& object, Size frame) {
    constexpr double around = 1.5;  // times the object's longer side
    constexpr int least = 40;       // pixels: of less, nobody sees where it is
    const int longer = std::max(object.width(), object.height());
    const int shorter_of_frame = std::min(frame.width, frame.height);
    const int side = std::min(std::max(least, static_cast<int>(longer * around)), shorter_of_frame);
    const int left = std::clamp((object.left + object.right - side) / 2, 0, frame.width - side);
    const int top = std::clamp((object.top + object.bottom - side) / 2, 0, frame.height - side);
    return {left, top, left + side, top + side};
}

void Crops::keep(std::size_t track, const events::Portrait& portrait, const video::Frame& frame) {
    if (frame.colour.empty() && frame.grey.empty()) return;  // data files without pictures
    const Size size = frame.colour.empty() ? frame.grey.size() : frame.colour.size();
    const PixelBox box = still_box(portrait.box, size);
    const Plane<Bgr> part = frame.colour.empty() ? cut_out(video::picture_of(frame), box) : cut_out(frame.colour, box);
    crops_[track] = {portrait.at, portrait.score, portrait.box.moved(-box.left, -box.top), part};
    if (crops_.size() <= most) return;
    crops_.erase(std::ranges::min_element(crops_, {}, [](const auto& entry) { return entry.second.score; }));
}

std::vector<Plane<Bgr>> portraits_of(std::span<const events::Event> events, const Crops& crops) {
    constexpr std::size_t many = 200;
    const int side = events.size() < many ? 72 : 40;
    std::vector<Plane<Bgr>> portraits;
    portraits.reserve(events.size());
    for (const events::Event& event : events) {
        const Crop* const crop = crops.of(event);
        portraits.push_back(crop == nullptr ? Plane<Bgr>() : image::resized(crop->picture, {side, side}));
    }
    return portraits;
}

const Crop* Crops::of(const events::Event& event) const {
    const Crop* best = nullptr;
    for (const std::size_t track : event.tracks) {
        const auto found = crops_.find(track);
        if (found == crops_.end()) continue;
        const Crop& crop = found->second;
        if (event.portrait && crop.at.frame == event.portrait->at.frame) return &crop;
        if (best == nullptr || crop.score > best->score) best = &crop;
    }
    return best;
}

}  // namespace vvr::glance
