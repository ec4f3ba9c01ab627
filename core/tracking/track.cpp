#include "core/tracking/track.h"

#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

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

void Track::record_position(const Moment& now, const PixelBox& box, const glm::dvec2& place, int area) {
    if (sightings_ == 0) {
        bounds_min_ = bounds_max_ = place;
        tracklet_.begin = {now, place, {}, touches_border(box, field_)};
        first_box_ = box;
    }
    tracklet_.end.at = now;
    tracklet_.box = bounding_box(tracklet_.box, box);
    bounds_min_ = glm::min(bounds_min_, place);
    bounds_max_ = glm::max(bounds_max_, place);
    ++sightings_;
    path_.add(now, place, area);
    if (!is<Standing>()) stays_.add(now, place, box, std::max(2.0, 0.15 * std::sqrt(static_cast<double>(area))));
}

void Track::update(const Patch& patch, const Appearance& appearance, const FrameView& sight,
                   const fields::Planes& scene, const Moment& now) {
    const double growth = static_cast<double>(patch.area) / std::max(1, patch_.area);
    detect_departure(patch, sight.field);
    auto& recent = motion_.recent;
    if (growth > thresholds.track.abrupt || growth < 1 / thresholds.track.abrupt) recent.clear();
    recent.push_back({now, patch.centre});
    while (recent.size() > 2 && now.seconds - recent.front().at.seconds > thresholds.track.velocity) recent.pop_front();
    const double span = now.seconds - recent.front().at.seconds;
    // Over a shorter time, a velocity is noise: what passes in front changes the outline for a few frames.
    if (span >= 0.5 * thresholds.track.velocity) {
        motion_.velocity = (patch.centre - recent.front().place) / span;
        if (!first_velocity_) first_velocity_ = motion_.velocity;
    }
    const glm::ivec2 shift = shift_at(now);
    const PixelBox moved = patch_.box.translated(shift.x, shift.y);
    if (sightings_ > 0 && (patch_.box.intersects(patch.box) || moved.intersects(patch.box))) ++continuous_;
    const double since = now.seconds - seen().seconds;
    const auto follow = [&](double& usual, double value) {
        usual += (sightings_ == 0 ? 1 : std::clamp(since / thresholds.track.adapts_in, 0.0, 0.5)) * (value - usual);
    };
    follow(tracklet_.size.x, patch.box.width());
    follow(tracklet_.size.y, patch.box.height());
    follow(tracklet_.area, patch.area);
    peak_area_ = std::max<double>(patch.area, peak_area_ * std::exp(-since / thresholds.track.adapts_in));
    motion_.place = patch.centre;
    motion_.at = now;
    patch_ = pixels_ = patch;
    template_ = Template(patch, sight);
    tracklet_.appearance.learn(appearance);
    state_ = Moving{};
    ++alone_;
    record_position(now, patch.box, patch.centre, patch.area);
    take_portrait(sight, patch, now);
    measure(sight, scene, now);
}

void Track::detect_departure(const Patch& patch, const Plane<std::uint8_t>& field) {
    const bool at_border = touches_border(patch.box, field_);
    const bool came_off = !at_border && touches_border(patch_.box, field_);
    if (at_border || came_off) departed_.reset();
    if (!came_off || patch.area >= thresholds.most * peak_area_) return;
    // What stood here before as it does now was only occluded.
    const auto& settled = tracklet_.settled;
    if (settled && part_alike(settled->patch, field) >= stationary.undisturbed) return;
    departed_ = tracklet(false, {}, seen());
}

void Track::measure(const FrameView& sight, const fields::Planes& scene, const Moment& now) {
    if (scene.grey.empty() || now.seconds < measure_due_) return;
    measure_due_ = now.seconds + thresholds.claim.sampled;
    const Difference now_differs = difference_of(patch_, sight, scene);
    Difference& mean = tracklet_.difference;
    const double weight = 1.0 / ++tracklet_.differences;
    mean.novelty += weight * (now_differs.novelty - mean.novelty);
    mean.texture += weight * (now_differs.texture - mean.texture);
}

void Track::move_to(const glm::dvec2& place, const Moment& now) {
    patch_ = translated(std::move(patch_), glm::ivec2(glm::round(place - patch_.centre)));
    motion_.place = place;
    motion_.at = now;
}

bool Track::update_merged(const TemplateMatch& share, const Patch& blob, const FrameView& sight, const Moment& now) {
    const double time = now.seconds - motion_.at.seconds;
    const glm::dvec2 expected = motion_.expected_at(now);
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
    if (found && time > 0) motion_.velocity += merged.correction * (found_at - expected) / std::max(time, 0.2);
    move_to(place, now);
    pixels_ = share.patch;
    tracklet_.box = bounding_box(tracklet_.box, pixels_.box);
    if (found) {
        record_position(now, patch_.box, place, patch_.area);
        take_portrait(sight, patch_, now, hindered);
    }
    return found;
}

void Track::coast(const Moment& now) {
    if (!is<Merged>()) state_ = Unseen{};
    move_to(motion_.expected_at(now), now);
}

const Moment& Track::steady_since(const Steadiness::Pixel& pixel) const {
    return pixel.since.frame < moved_again_at_.frame ? moved_again_at_ : pixel.since;
}

bool Track::is_steady(const Steadiness::Pixel& pixel, const Moment& now) const {
    const Moment& since = steady_since(pixel);
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
void Track::restart(const Moment& still, const Moment& now) {
    tracklet_.box = patch_.box;
    bounds_min_ = bounds_max_ = patch_.centre;
    tracklet_.begin = {still, patch_.centre, {}, touches_border(patch_.box, field_)};
    if (first_velocity_) *first_velocity_ = glm::dvec2();
    path_ = Path();
    path_.add(still, patch_.centre, patch_.area);
    stays_ = Stays(stationary.stay);
    tracklet_.portrait.reset();
    sightings_ = static_cast<int>(now.frame - still.frame);
}

/// Whether the object that settled again has the pixels that it had, and no others.
bool Track::is_unchanged(const Patch& before, const Plane<std::uint8_t>& field) const {
    const Patch both = part_of(patch_, [&](int i, int j) { return before.at(i, j) != 0; });
    return both.area >= stationary.undisturbed * patch_.area && part_alike(before, field) >= stationary.undisturbed;
}

void Track::settle(const Steadiness& steadiness, const Flicker& flicker, const FrameView& sight,
                   const fields::Planes& scene, const Moment& now) {
    auto& settled = tracklet_.settled;
    const bool young = now.seconds - first().seconds < 2 * stationary.stay;
    const bool small = patch_.area < thresholds.most * origin_.area;
    const bool out_of_another = origin_.track.has_value() && (young || small);
    std::vector<Moment> since;
    patch_ = part_of(patch_, [&](int i, int j) {
        const Steadiness::Pixel& pixel = steadiness.at(i, j);
        if (!is_steady(pixel, now)) return false;
        since.push_back(steady_since(pixel));
        return true;
    });
    for_each_pixel(patch_, [&](int i, int j, std::uint8_t) {
        patch_.values.at(i - patch_.box.left, j - patch_.box.top) = steadiness.at(i, j).level;
    });
    const Moment still_since = nearly_last_of(std::move(since));
    Moment still = still_since;
    // What was only occluded, and looks as before, stands as before: it did not move by itself.
    if (!settled || !is_unchanged(settled->patch, sight.field)) {
        double moved = glm::distance(bounds_min_, bounds_max_) / length();
        bool found_standing = true;
        if (out_of_another) {
            // Where its first blob already covered its place, the bearer's parts moved in that blob.
            if (is_mostly_inside(patch_.box, first_box_)) moved = 0;
            restart(still, now);
        } else {
            // An object that never moved is a ghost, or appeared there.
            // Of its width or its height: a person who has moved by their width stands elsewhere.
            const glm::dvec2 moved_by =
                (bounds_max_ - bounds_min_) / glm::max(tracklet_.size, glm::dvec2(thresholds.least_length));
            found_standing = std::max(moved_by.x, moved_by.y) < stationary.near_place;
            if (still.frame < first().frame) still = first();
            // A plain surface is steady shortly before it stops.
            const auto& open = stays_.open();
            if (open && open->first.frame > still.frame && open->first.seconds - still.seconds < stationary.stay) {
                still = open->first;
            }
        }
        settled = Settled{patch_, still_since, {.moved = moved, .flicker = flicker.of(patch_)}, {}, found_standing};
    }
    state_ = Standing{{still, now, patch_.centre, patch_.box}, StillPicture(patch_, field_)};
    motion_ = {.place = patch_.centre, .at = now};
    update_stationary(sight, scene, now, true, true);
}

bool Track::belongs_to(const Track& other) const {
    const PixelBox& larger = patch_.area > other.patch_.area ? patch_.box : other.patch_.box;
    const int reach = 3 + static_cast<int>(stationary.apart * std::max(larger.width(), larger.height()));
    // Who walks on from what is already still there is another.
    const auto came_from_afar = [&](const Track& one, const Track& still) {
        return still.first().frame > one.first().frame &&
               glm::distance(place_at(one.path_.points(), still.first().frame), one.patch_.centre) > reach;
    };
    return patch_.box.inflated(reach, reach).intersects(other.patch_.box) &&
           std::abs(still_since().seconds - other.still_since().seconds) <= stationary.stay &&
           !came_from_afar(*this, other) && !came_from_afar(other, *this);
}

void Track::add_part(const Track& part) {
    Standing& standing = std::get<Standing>(state_);
    patch_ = joined(patch_, part.patch_);
    tracklet_.box = bounding_box(tracklet_.box, patch_.box);
    motion_.place = standing.stay.place = patch_.centre;
    standing.stay.box = patch_.box;
    tracklet_.settled->patch = patch_;
    // What has been seen so far counts: a scrap may come when somebody bends down to the thing.
    if (standing.picture.box().contains(patch_.box)) return;
    standing.picture = StillPicture(patch_, field_);
    tracklet_.portrait.reset();
    portrait_due_ = 0;
}

double Track::visible_part(const Plane<std::uint8_t>& field) const {
    return part_alike(patch_, field);
}

void Track::update_stationary(const FrameView& sight, const fields::Planes& scene, const Moment& now, bool whole,
                              bool beside) {
    Standing& standing = std::get<Standing>(state_);
    standing.stay.last = now;
    pixels_ = patch_;
    record_position(now, patch_.box, patch_.centre, patch_.area);
    // Not only while it is whole: a shadow that counted as a part of it may have gone.
    if (!beside && standing.alone_at) {
        tracklet_.settled->evidence.alone += now.seconds - standing.alone_at->seconds;
    }
    standing.alone_at = beside ? std::nullopt : std::optional(now);
    if (whole) {
        standing.picture.add(sight, now);
        standing.whole_at = now;
        standing.near.reset();
        measure(sight, scene, now);
        take_portrait(sight, patch_, now);
    }
}

bool Track::shows_scene(const fields::Planes& scene) const {
    const auto* const standing = std::get_if<Standing>(&state_);
    if (standing == nullptr || standing->stay.first.seconds - first().seconds < thresholds.event.least) return false;
    const auto differs = compare_with_scene(standing->picture, tracklet_.settled->patch, scene);
    return differs && differs->scene_edges >= thresholds.stationary.uncovered * differs->edges;
}

/// Leaves the last stay out.
void Track::end_before_stay(Tracklet& result) const {
    const Moment& end = std::get<Standing>(state_).stay.first;
    while (result.path.size() > 1 && result.path.back().at.frame > end.frame) {
        result.path.pop_back();
        result.areas.pop_back();
    }
    result.end.at = end;
    result.end.place = result.path.back().place;
    result.end.at_border = touches_border(result.box, field_);
    if (result.portrait && result.portrait->at.frame > end.frame) result.portrait.reset();
    result.settled.reset();
    result.seen = 1;
}

void Track::move_again(const Moment& now) {
    moved_again_at_ = now;
    // A plain surface looks still for a while after it starts to move, because it covers itself.
    Standing& standing = std::get<Standing>(state_);
    standing.stay.last = standing.whole_at;
    stays_.add_exactly(standing.stay);
    state_ = Moving{};
}

void Track::join(const Track& fragment) {
    if (fragment.first().frame < first().frame) tracklet_.begin.at = fragment.first();
    tracklet_.box = bounding_box(tracklet_.box, fragment.tracklet_.box);
}

void Track::take_portrait(const FrameView& sight, const Patch& patch, const Moment& now, double worth) {
    if (now.seconds < portrait_due_) return;
    portrait_due_ = now.seconds + thresholds.claim.sampled;
    if (touches_border(patch.box, field_)) worth *= hindered;
    if (sight.damaged) worth *= hindered * hindered;
    const double score =
        worth * std::sqrt(static_cast<double>(patch.area)) * std::sqrt(1 + mean_gradient(patch, sight));
    auto& best = tracklet_.portrait;
    if (!best || score > best->score) best = Portrait{now, patch.box, score};
}

Tracklet Track::tracklet(bool taken, const fields::Planes& scene, const Moment& now) const {
    Tracklet result = tracklet_;
    Stays stays = stays_;
    if (const auto* const merged = std::get_if<Merged>(&state_); merged && taken) result.into = merged->near;
    const bool gone_before = shows_scene(scene);
    if (const auto* const standing = std::get_if<Standing>(&state_); standing && !gone_before) {
        if (taken) result.into = standing->near;
        stays.add_exactly(standing->stay);
        result.stood_to_end = true;
        result.stood_from_start = found_standing();
        result.gone = standing->uncovered.value_or(now);
        if (auto differs = compare_with_scene(standing->picture, result.settled->patch, scene)) {
            Evidence& evidence = result.settled->evidence;
            evidence.difference = differs->difference;
            evidence.edges = differs->edges;
            evidence.scene_edges = differs->scene_edges;
            evidence.thickness = differs->thickness;
            result.settled->region = std::move(differs->region);
        }
    }
    const glm::ivec2 shift(glm::round(motion_.velocity * 0.2));
    result.path = path_.points();
    result.areas = path_.areas();
    result.stays = stays.finish();
    result.begin.velocity = first_velocity_.value_or(motion_.velocity);
    result.end = {seen(), result.path.empty() ? motion_.place : result.path.back().place, motion_.velocity,
                  touches_border(patch_.box.translated(shift.x, shift.y), field_)};
    result.length = std::max(result.size.x, result.size.y);
    const auto frames = static_cast<double>(seen().frame - first().frame + 1);
    result.seen = std::min(1.0, sightings_ / std::max(1.0, frames));
    result.continuous = alone_ > 1 ? static_cast<double>(continuous_) / (alone_ - 1) : 1;
    result.moved = glm::distance(bounds_min_, bounds_max_);
    if (gone_before) end_before_stay(result);
    return result;
}

}  // namespace vvr::tracking
