#include "core/annotation/crops.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/image/jpeg.h"
#include "core/image/picture.h"
#include "core/media/scaler.h"

namespace vvr::annotation {

namespace {

// Side of a square / longer side of the object in it.
constexpr double around_still = 1.5;
constexpr double around_wide = 2.5;

/// The square around an object, moved into the frame. A square with a larger `around` contains one with a smaller.
PixelBox square_around(const PixelBox& object, double around, Size frame) {
    constexpr double shortest = 40 / around_still;  // pixels; in a still of a smaller object, its surroundings are lost
    const double longer = std::max<double>(shortest, std::max(object.width(), object.height()));
    const int side = std::min({static_cast<int>(longer * around), frame.width, frame.height});
    const int left = std::clamp((object.left + object.right - side) / 2, 0, frame.width - side);
    const int top = std::clamp((object.top + object.bottom - side) / 2, 0, frame.height - side);
    return {left, top, left + side, top + side};
}

PixelBox scaled(const PixelBox& box, double scale) {
    const auto at = [scale](int value) { return static_cast<int>(std::lround(value * scale)); };
    return {at(box.left), at(box.top), at(box.right), at(box.bottom)};
}

}  // namespace

PixelBox still_box(const PixelBox& object, Size frame) {
    return square_around(object, around_still, frame);
}

PixelBox ObjectPicture::in_field(const PixelBox& box) const {
    return scaled(box, 1 / scale).translated(origin.x, origin.y);
}

Crop::Crop(const tracking::Portrait& portrait, const media::Frame& frame) : at_(portrait.at), score_(portrait.score) {
    const Size size = frame.colour.empty() ? frame.grey.size() : frame.colour.size();
    const PixelBox wide = square_around(portrait.box, around_wide, size);
    raw_ = media::crop_of(frame, wide, longest_side);
    scale_ = static_cast<double>(raw_.width()) / wide.width();
    origin_ = {wide.left, wide.top};
    object_ = portrait.box.translated(-wide.left, -wide.top);
    still_ = still_box(portrait.box, size).translated(-wide.left, -wide.top);
}

void Crop::compress() {
    if (!is_raw()) return;
    jpeg_ = image::compress(raw_);
    raw_ = {};
}

ObjectPicture Crop::surroundings() const {
    return {image::decompress(is_raw() ? image::compress(raw_) : jpeg_), scaled(object_, scale_), scale_, origin_};
}

ObjectPicture Crop::still() const {
    const ObjectPicture wide = surroundings();
    PixelBox box = scaled(still_, scale_);
    const int side = std::min({box.width(), wide.picture.width() - box.left, wide.picture.height() - box.top});
    box = {box.left, box.top, box.left + side, box.top + side};
    return {cropped(wide.picture, box), wide.object.translated(-box.left, -box.top), scale_,
            origin_ + glm::ivec2(still_.left, still_.top)};
}

void Crops::keep(std::size_t track, const tracking::Portrait& portrait, const media::Frame& frame) {
    if (frame.colour.empty() && frame.grey.empty()) return;  // data files without pictures
    make_room(track);
    const Crop& crop = crops_.emplace(Key(track, 0), Crop(portrait, frame)).first->second;
    bytes_ += crop.bytes();
    raw_bytes_ += crop.bytes();
    while (raw_bytes_ > max_raw_bytes) compress_oldest();
    while (crops_.size() > max_crops || bytes_ > max_bytes) {
        remove(std::ranges::min_element(crops_, {}, [](const auto& entry) { return entry.second.score(); }));
    }
}

void Crops::forget_before(double seconds, const std::function<bool(std::size_t track)>& is_over) {
    for (auto place = crops_.begin(); place != crops_.end();) {
        const auto next = std::next(place);
        if (place->second.at().seconds < seconds && is_over(place->first.first)) remove(place);
        place = next;
    }
}

/// Removes a track's best crop, or makes it one of an earlier moment.
void Crops::make_room(std::size_t track) {
    constexpr double apart = 1;  // seconds; what was hidden a moment ago still is
    const auto best = crops_.find({track, 0});
    if (best == crops_.end()) return;
    const auto earlier = crops_.find({track, 1});
    const bool is_far = earlier == crops_.end() || best->second.at().seconds - earlier->second.at().seconds >= apart;
    if (per_track_ == 1 || !is_far) {
        remove(best);
        return;
    }
    if (const auto last = crops_.find({track, per_track_ - 1}); last != crops_.end()) remove(last);
    for (int place = per_track_ - 2; place >= 0; --place) {
        auto moved = crops_.extract({track, place});
        if (moved.empty()) continue;
        moved.key().second = place + 1;
        crops_.insert(std::move(moved));
    }
}

void Crops::remove(std::map<Key, Crop>::iterator place) {
    bytes_ -= place->second.bytes();
    if (place->second.is_raw()) raw_bytes_ -= place->second.bytes();
    crops_.erase(place);
}

/// Compresses the raw crop that has not been replaced for longest.
void Crops::compress_oldest() {
    Crop* oldest = nullptr;
    for (auto& [key, crop] : crops_) {
        if (crop.is_raw() && (oldest == nullptr || crop.at().frame < oldest->at().frame)) oldest = &crop;
    }
    if (oldest == nullptr) return;
    bytes_ -= oldest->bytes();
    raw_bytes_ -= oldest->bytes();
    oldest->compress();
    bytes_ += oldest->bytes();
}

const Crop* Crops::find(const tracking::Event& event) const {
    const Crop* best = nullptr;
    for (const std::size_t track : event.tracks) {
        const auto found = crops_.find({track, 0});
        if (found == crops_.end()) continue;
        const Crop& crop = found->second;
        if (event.portrait && crop.at().frame == event.portrait->at.frame) return &crop;
        if (best == nullptr || crop.score() > best->score()) best = &crop;
    }
    return best;
}

const BeforeAndAfter* Crops::find_pair(const tracking::Event& event) const {
    const auto found = event.tracks.empty() ? pairs_.end() : pairs_.find(event.tracks.front());
    return found == pairs_.end() ? nullptr : &found->second;
}

std::vector<std::pair<std::size_t, const Crop*>> Crops::all(const tracking::Event& event) const {
    std::vector<std::pair<std::size_t, const Crop*>> all;
    for (int place = 0; place < per_track_; ++place) {
        const auto before = std::ssize(all);
        for (const std::size_t track : event.tracks) {
            if (const auto found = crops_.find({track, place}); found != crops_.end()) {
                all.emplace_back(track, &found->second);
            }
        }
        std::ranges::stable_sort(all.begin() + before, all.end(), std::greater(),
                                 [](const auto& one) { return one.second->score(); });
    }
    return all;
}

std::vector<Plane<Bgr>> portraits_of(std::span<const tracking::Event> events, const Crops& crops) {
    constexpr std::size_t few = 60;
    constexpr std::size_t many = 200;
    const int side = events.size() <= few ? 144 : events.size() < many ? 72 : 40;
    std::vector<Plane<Bgr>> portraits;
    portraits.reserve(events.size());
    for (const tracking::Event& event : events) {
        const Crop* const crop = crops.find(event);
        portraits.push_back(crop == nullptr ? Plane<Bgr>() : image::resized(crop->still().picture, {side, side}));
    }
    return portraits;
}

}  // namespace vvr::annotation
