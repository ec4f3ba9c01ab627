#include "core/tracking/track.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "core/tracking/patch.h"

namespace vvr::tracking {

namespace {

constexpr auto& stationary = thresholds.stationary;

/// Factor of the score of a portrait of an object that others or the border of the picture hide in part.
constexpr double hindered = 0.3;

double part_alike(const Patch& patch, const Plane<std::uint8_t>& field) {
    int alike = 0;
    for_each_pixel(patch, [&](int i, int j, std::uint8_t value) {
        const bool within = i >= 0 && i < field.width() && j >= 0 && j < field.height();
        if (within && Steadiness::alike(field.at(i, j), value)) ++alike;
    });
    return static_cast<double>(alike) / std::max(1, patch.area);
}

/// The 90th percentile. The front edge of an object that slows down comes to rest last, and is about a tenth of it;
/// later pixels were occluded by the bearer.
Moment nearly_last_of(std::vector<Moment> moments) {
    const auto place = moments.begin() + (std::ssize(moments) - 1) * 9 / 10;
    std::ranges::nth_element(moments, place, {}, &Moment::frame);
    return *place;
}

double mean_gradient(const Patch& patch, const FrameView& sight) {
    double sum = 0;
    int count = 0;
    for (int j = patch.box.top + 1; j < patch.box.bottom; j += 2) {
        for (int i = patch.box.left + 1; i < patch.box.right; i += 2) {
            if (patch.at(i, j) == 0 || i < 1 || j < 1 || i >= sight.field.width() || j >= sight.field.height())
                continue;
            const int here = sight.brightness(i, j);
            sum += std::abs(here - sight.brightness(i - 1, j)) + std::abs(here - sight.brightness(i, j - 1));
            ++count;
        }
    }
    return sum / std::max(1, count);
}

}  // namespace

glm::ivec2 Track::shift_at(const Moment& now) const {
    return glm::ivec2(glm::round(expected_at(now) - patch_.centre));
}

glm::ivec2 Track::template_shift_at(const Moment& now) const {
    return glm::ivec2(glm::round(expected_at(now) - template_.patch.centre));
}

PixelBox Track::moved_box_at(const Moment& now) const {
    const glm::ivec2 shift = shift_at(now);
    return patch_.box.translated(shift.x, shift.y);
}

void Track::record_position(const Moment& now, const PixelBox& box, const glm::dvec2& place, int area) {
    if (sightings_ == 0) {
        first_ = now;
        low_ = place;
        high_ = place;
        begin_ = {now, place, {}, touches_border(box, field_)};
        first_box_ = box;
    }
    seen_ = now;
    box_ = bounding_box(box_, box);
    low_ = glm::min(low_, place);
    high_ = glm::max(high_, place);
    ++sightings_;
    path_.add(now, place, area);
    if (!stands()) stays_.add(now, place, box, std::max(2.0, 0.15 * std::sqrt(static_cast<double>(area))));
}

void Track::see(const Patch& patch, const Appearance& look, const FrameView& sight, const Moment& now) {
    const double growth = static_cast<double>(patch.area) / std::max(1, patch_.area);
    look_for_departure(patch, sight.field);
    if (state_ == State::merged || growth > thresholds.track.abrupt || growth < 1 / thresholds.track.abrupt)
        recent_.clear();
    recent_.push_back({now, patch.centre});
    while (recent_.size() > 2 && now.seconds - recent_.front().at.seconds > thresholds.track.velocity)
        recent_.pop_front();
    const double span = now.seconds - recent_.front().at.seconds;
    // Over a shorter time, a velocity is noise: what passes in front changes the outline for a few frames.
    if (span >= 0.5 * thresholds.track.velocity) {
        velocity_ = (patch.centre - recent_.front().place) / span;
        if (!first_velocity_) first_velocity_ = velocity_;
    }
    if (sightings_ > 0 && (patch_.box.intersects(patch.box) || moved_box_at(now).intersects(patch.box))) ++continuous_;
    const glm::dvec2 size(patch.box.width(), patch.box.height());
    const double since = now.seconds - seen_.seconds;
    const auto follow = [&](double& usual, double value) {
        usual += (sightings_ == 0 ? 1 : std::clamp(since / thresholds.track.adapts_in, 0.0, 0.5)) * (value - usual);
    };
    follow(usual_size_.x, size.x);
    follow(usual_size_.y, size.y);
    follow(usual_area_, patch.area);
    peak_area_ = std::max<double>(patch.area, peak_area_ * std::exp(-since / thresholds.track.adapts_in));
    place_ = patch.centre;
    place_at_ = now;
    patch_ = patch;
    pixels_ = patch;
    template_ = Template(patch, sight);
    look_.learn(look);
    state_ = State::moving;
    ++alone_;
    record_position(now, patch.box, patch.centre, patch.area);
    take_portrait(sight, patch, now);
}

void Track::look_for_departure(const Patch& patch, const Plane<std::uint8_t>& field) {
    const bool at_border = touches_border(patch.box, field_);
    const bool came_off = !at_border && touches_border(patch_.box, field_);
    if (at_border || came_off) departed_.reset();
    if (!came_off || patch.area >= thresholds.most * peak_area_) return;
    // What stood here before as it does now was only occluded.
    if (settled_ && part_alike(settled_->patch, field) >= stationary.undisturbed) return;
    departed_ = std::make_shared<const Track>(*this);
}

void Track::look_for_novelty(const FrameView& sight, const fields::Planes& scene, const Moment& now) {
    if (scene.grey.empty() || now.seconds < novelty_due_) return;
    novelty_due_ = now.seconds + thresholds.claim.sampled;
    const PixelBox box = intersection(patch_.box, {0, 0, field_.width, field_.height});
    const Patch all{box, Plane<std::uint8_t>(box.size(), 1), box.width() * box.height(), {}};
    const FrameView empty{sight.field, scene.grey, scene.colour};
    novelty_ += (distance(Appearance(all, sight), Appearance(all, empty)) - novelty_) / ++novelties_;
}

void Track::move_to(const glm::dvec2& place, const Moment& now) {
    patch_ = translated(std::move(patch_), glm::ivec2(glm::round(place - patch_.centre)));
    place_ = place;
    place_at_ = now;
}

bool Track::update_merged(const TemplateMatch& share, const Patch& blob, const FrameView& sight, const Moment& now) {
    state_ = State::merged;
    const double time = now.seconds - place_at_.seconds;
    const glm::dvec2 expected = expected_at(now);
    constexpr auto& merged = thresholds.merged;
    const bool found = share.similarity >= merged.similarity;
    const glm::dvec2 found_at = template_.patch.centre + glm::dvec2(share.shift);
    glm::dvec2 place = found ? found_at : expected;
    // Within the blob it may be anywhere; it may leave the blob only at the border of the picture.
    const bool leaves = touches_border(blob.box, field_) && touches_border(patch_.box, field_);
    if (!leaves) {
        const glm::dvec2 low(blob.box.left, blob.box.top);
        const glm::dvec2 high(blob.box.right - 1, blob.box.bottom - 1);
        place = glm::clamp(place, low, high);
    }
    if (found && time > 0) velocity_ += merged.correction * (found_at - expected) / std::max(time, 0.2);
    move_to(place, now);
    pixels_ = share.patch;
    box_ = bounding_box(box_, pixels_.box);
    recent_.clear();
    if (found) {
        record_position(now, patch_.box, place, patch_.area);
        take_portrait(sight, patch_, now, hindered);
    }
    return found;
}

void Track::miss(const Moment& now) {
    if (state_ != State::merged) state_ = State::unseen;
    move_to(expected_at(now), now);
}

bool Track::is_steady(const Steadiness::Pixel& pixel, const Moment& now) const {
    const Moment& since = pixel.since.frame < risen_.frame ? risen_ : pixel.since;
    return pixel.level != 0 && now.seconds - since.seconds >= stationary.stay &&
           now.frame - since.frame >= stationary.sightings;
}

bool Track::has_settled(const Steadiness& steadiness, const Flicker& flicker, const Moment& now) const {
    int steady = 0;
    for_each_pixel(patch_, [&](int i, int j, std::uint8_t) {
        if (is_steady(steadiness.at(i, j), now)) ++steady;
    });
    return steady >= stationary.settled_part * patch_.area && flicker.of(patch_) < thresholds.pixel.flicker;
}

/// Forgets what was before a moment: until then, the track was the bearer.
void Track::begin_again(const Moment& still, const Moment& now) {
    first_ = still;
    box_ = patch_.box;
    low_ = high_ = patch_.centre;
    begin_ = {still, patch_.centre, {}, touches_border(patch_.box, field_)};
    if (first_velocity_) *first_velocity_ = glm::dvec2();
    path_ = Path();
    path_.add(first_, patch_.centre, patch_.area);
    stays_ = Stays(stationary.stay);
    portrait_.reset();
    sightings_ = static_cast<int>(now.frame - still.frame);
}

/// Whether the object that settled again has the pixels that it had, and no others.
bool Track::is_unchanged(const Patch& before, const Plane<std::uint8_t>& field) const {
    const Patch both = part_of(patch_, [&](int i, int j) { return before.at(i, j) != 0; });
    return both.area >= stationary.undisturbed * patch_.area && part_alike(before, field) >= stationary.undisturbed;
}

void Track::settle(const Steadiness& steadiness, const Flicker& flicker, const FrameView& sight, const Moment& now) {
    const bool young = now.seconds - first_.seconds < 2 * stationary.stay;
    const bool small = patch_.area < thresholds.most * origin_.area;
    const bool out_of_another = origin_.track.has_value() && (young || small);
    std::vector<Moment> since;
    patch_ = part_of(patch_, [&](int i, int j) {
        const Steadiness::Pixel& pixel = steadiness.at(i, j);
        if (!is_steady(pixel, now)) return false;
        since.push_back(pixel.since.frame < risen_.frame ? risen_ : pixel.since);
        return true;
    });
    for_each_pixel(patch_, [&](int i, int j, std::uint8_t) {
        patch_.values.at(i - patch_.box.left, j - patch_.box.top) = steadiness.at(i, j).level;
    });
    const Moment still_since = nearly_last_of(std::move(since));
    Moment still = still_since;
    const double length = std::max({thresholds.least_length, usual_size_.x, usual_size_.y});
    double moved = glm::distance(low_, high_) / length;
    // What was only occluded, and looks as before, stands as before: it did not move by itself.
    const bool was_occluded = settled_ && is_unchanged(settled_->patch, sight.field);
    if (was_occluded) {
        state_ = stood_as_;
    } else if (out_of_another) {
        // Where its first blob already covered its place, the bearer's parts moved in that blob.
        if (is_mostly_inside(patch_.box, first_box_)) moved = 0;
        begin_again(still, now);
        state_ = State::appeared;
    } else {
        // An object that never moved is a ghost, or appeared there.
        // Of its width or its height: a person who has moved by their width stands elsewhere.
        const glm::dvec2 moved_by = (high_ - low_) / glm::max(usual_size_, glm::dvec2(thresholds.least_length));
        const bool was_near = std::max(moved_by.x, moved_by.y) < stationary.near_place;
        state_ = was_near ? State::appeared : State::standing;
        if (still.frame < first_.frame) still = first_;
        // A plain surface is steady shortly before it stops.
        const auto& open = stays_.open();
        if (open && open->first.frame > still.frame && open->first.seconds - still.seconds < stationary.stay) {
            still = open->first;
        }
    }
    if (!was_occluded) settled_ = Settled{patch_, still_since, {.moved = moved, .flicker = flicker.of(patch_)}, {}};
    still_ = StillPicture(patch_, field_);
    velocity_ = {};
    place_ = patch_.centre;
    place_at_ = now;
    recent_.clear();
    stay_ = {still, now, patch_.centre, patch_.box};
    uncovered_.reset();
    update_stationary(sight, now, true, true);
}

bool Track::belongs_to(const Track& other) const {
    const PixelBox& larger = patch_.area > other.patch_.area ? patch_.box : other.patch_.box;
    const int reach = 3 + static_cast<int>(stationary.apart * std::max(larger.width(), larger.height()));
    return patch_.box.inflated(reach, reach).intersects(other.patch_.box) &&
           std::abs(settled_->since.seconds - other.settled_->since.seconds) <= stationary.stay;
}

void Track::add_part(const Track& part) {
    patch_ = joined(patch_, part.patch_);
    box_ = bounding_box(box_, patch_.box);
    place_ = patch_.centre;
    stay_.place = patch_.centre;
    stay_.box = patch_.box;
    settled_->patch = patch_;
    // What has been seen so far counts: a scrap may come when somebody bends down to the thing.
    if (still_.box().contains(patch_.box)) return;
    still_ = StillPicture(patch_, field_);
    portrait_.reset();
    portrait_due_ = 0;
}

double Track::visible_part(const Plane<std::uint8_t>& field) const {
    return part_alike(patch_, field);
}

void Track::update_stationary(const FrameView& sight, const Moment& now, bool whole, bool beside) {
    stay_.last = now;
    pixels_ = patch_;
    record_position(now, patch_.box, patch_.centre, patch_.area);
    // Not only while it is whole: a shadow that counted as a part of it may have gone.
    if (!beside && alone_at_) settled_->evidence.alone += now.seconds - alone_at_->seconds;
    alone_at_ = beside ? std::nullopt : std::optional(now);
    if (whole) {
        still_.add(sight, now);
        last_whole_ = now;
        near_.reset();
        take_portrait(sight, patch_, now);
    }
}

void Track::resume_motion(const Moment& now) {
    risen_ = now;
    stood_as_ = state_;
    // A plain surface looks still for a while after it starts to move, because it covers itself.
    stay_.last = last_whole_;
    stays_.add_exactly(stay_);
    state_ = State::moving;
    still_ = {};
}

void Track::join(const Track& piece) {
    if (piece.first_.frame < first_.frame) first_ = piece.first_;
    box_ = bounding_box(box_, piece.box_);
}

void Track::take_portrait(const FrameView& sight, const Patch& patch, const Moment& now, double worth) {
    if (now.seconds < portrait_due_) return;
    portrait_due_ = now.seconds + thresholds.claim.sampled;
    if (touches_border(patch.box, field_)) worth *= hindered;
    const double score =
        worth * std::sqrt(static_cast<double>(patch.area)) * std::sqrt(1 + mean_gradient(patch, sight));
    if (!portrait_ || score > portrait_->score) portrait_ = Portrait{now, patch.box, score};
}

Tracklet Track::finish(std::optional<std::size_t> into, const fields::Planes& scene, const Moment& now) {
    Tracklet result;
    result.stood_to_end = stands();
    result.gone = uncovered_.value_or(now);
    result.stood_from_start = state_ == State::appeared;
    if (stands()) stays_.add_exactly(stay_);
    state_ = State::over;
    result.number = number_;
    result.from = origin_.track;
    result.into = into;
    result.begin = begin_;
    result.begin.at = first_;
    const PixelBox last_box = translated(patch_, glm::ivec2(glm::round(velocity_ * 0.2))).box;
    result.path = path_.points();
    result.areas = path_.areas();
    result.end = {seen_, result.path.empty() ? place_ : result.path.back().place, velocity_,
                  touches_border(last_box, field_)};
    result.begin.velocity = first_velocity_.value_or(velocity_);
    result.length = std::max(usual_size_.x, usual_size_.y);
    result.size = usual_size_;
    result.area = usual_area_;
    result.area_of_parent = origin_.was_alone ? origin_.area : 0;
    const auto frames = static_cast<double>(seen_.frame - first_.frame + 1);
    result.seen = std::min(1.0, sightings_ / std::max(1.0, frames));
    result.continuous = alone_ > 1 ? static_cast<double>(continuous_) / (alone_ - 1) : 1;
    result.moved = glm::distance(low_, high_);
    if (novelties_ > 0) result.novelty = novelty_;
    result.box = box_;
    result.look = look_;
    result.stays = stays_.finish();
    if (settled_) {
        if (auto differs = compare_with_scene(still_, settled_->patch, scene)) {
            settled_->evidence.difference = differs->difference;
            settled_->evidence.edges = differs->edges;
            settled_->evidence.scene_edges = differs->scene_edges;
            settled_->evidence.thickness = differs->thickness;
            settled_->region = std::move(differs->region);
        }
    }
    result.settled = std::move(settled_);
    result.portrait = portrait_;
    return result;
}

}  // namespace vvr::tracking
