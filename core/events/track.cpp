#include "core/events/track.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vvr {

namespace {

constexpr std::size_t most_recent = 10;
// A patch that becomes so much larger or smaller from one field to the next has met or lost something.
constexpr double abrupt = 1.5;
constexpr double settled_part = 0.6;
constexpr double like_part = 0.5;
constexpr int search = 2;
// What only flutters at its place goes less far than it is long, and is not to be seen every so often.
constexpr double own_lengths = 1.25;
constexpr double seen_part = 0.6;

Patch moved(Patch patch, const glm::ivec2& by) {
    patch.box = patch.box.moved(by.x, by.y);
    patch.centre += by;
    return patch;
}

double like(const Patch& patch, const glm::ivec2& by, const Plane<std::uint8_t>& field) {
    int alike = 0;
    for_each_pixel(patch, [&](int i, int j, std::uint8_t value) {
        const int x = i + by.x;
        const int y = j + by.y;
        const bool within = x >= 0 && x < field.width() && y >= 0 && y < field.height();
        if (within && Steadiness::alike(field.at(x, y), value)) ++alike;
    });
    return static_cast<double>(alike) / std::max(1, patch.area);
}

/// When nearly all were reached. Of what comes to rest slowly the foremost edge does so last, and it is a tenth of it;
/// the few that are later still were hidden behind whoever brought it.
Moment nearly_last_of(std::vector<Moment> moments) {
    const auto place = moments.begin() + (std::ssize(moments) - 1) * 9 / 10;
    std::ranges::nth_element(moments, place, {}, &Moment::frame);
    return *place;
}

}  // namespace

Track::Track(std::size_t number, const Patch& patch, const Moment& now, const EventOptions& options)
    : number_(number), options_(options), patch_(patch), first_(now), stays_(options.stay) {
    recent_.push_back(patch.centre);
    went_on(now, patch.box, patch.centre);
}

bool Track::is_certain() const {
    return seen_.seconds - first_.seconds >= options_.least;
}

bool Track::is_event() const {
    const double mean_side = sides_ / std::max(1, sightings_);
    const auto frames = static_cast<double>(seen_.frame - first_.frame + 1);
    const bool went = glm::distance(low_, high_) >= own_lengths * mean_side && sightings_ >= seen_part * frames;
    return is_certain() && (settled_ || went);
}

void Track::went_on(const Moment& now, const PixelBox& box, const glm::dvec2& place) {
    seen_ = now;
    box_ = hull_of(box_, box);
    low_ = sightings_ == 0 ? place : glm::min(low_, place);
    high_ = sightings_ == 0 ? place : glm::max(high_, place);
    sides_ += std::max(box.width(), box.height());
    ++sightings_;
    path_.add(now, place);
    const double reach = std::max(2.0, 0.15 * std::sqrt(static_cast<double>(patch_.area)));
    if (!stands_) stays_.add(now, place, box, reach);
}

void Track::see(const Patch& patch, const Moment& now) {
    const double growth = static_cast<double>(patch.area) / std::max(1, patch_.area);
    if (merged_ || growth > abrupt || growth < 1 / abrupt) recent_.clear();
    recent_.push_back(patch.centre);
    if (recent_.size() > most_recent) recent_.pop_front();
    if (recent_.size() > 1) velocity_ = (recent_.back() - recent_.front()) / static_cast<double>(recent_.size() - 1);
    patch_ = patch;
    shift_ = {};
    merged_ = false;
    went_on(now, patch.box, patch.centre);
}

bool Track::see_within(const Plane<std::uint8_t>& field, const Moment& now) {
    merged_ = true;
    shift_ += velocity_;
    const glm::ivec2 expected(glm::round(shift_));
    glm::ivec2 best = expected;
    double most = like(patch_, expected, field);
    for (int y = -search; y <= search; ++y) {
        for (int x = -search; x <= search; ++x) {
            const double here = like(patch_, expected + glm::ivec2(x, y), field);
            if (here > most) {
                most = here;
                best = expected + glm::ivec2(x, y);
            }
        }
    }
    if (most >= like_part) {
        velocity_ += 0.1 * glm::dvec2(best - expected);
        shift_ += best - expected;
    }
    const glm::ivec2 whole(glm::round(shift_));
    patch_ = moved(std::move(patch_), whole);
    shift_ -= whole;
    if (most < like_part) return false;
    went_on(now, patch_.box, patch_.centre);
    return true;
}

void Track::miss() {
    shift_ += velocity_;
    const glm::ivec2 whole(glm::round(shift_));
    patch_ = moved(std::move(patch_), whole);
    shift_ -= whole;
}

bool Track::has_settled(const Steadiness& steadiness, const Moment& now) const {
    int steady = 0;
    for_each_pixel(patch_, [&](int i, int j, std::uint8_t) {
        const Steadiness::Pixel& pixel = steadiness.at(i, j);
        if (pixel.level != 0 && now.seconds - pixel.since.seconds >= options_.stay) ++steady;
    });
    return steady >= settled_part * patch_.area;
}

void Track::settle(const Steadiness& steadiness, const Moment& now, bool out_of_another) {
    std::vector<Moment> since;
    patch_ = part_of(patch_, [&](int i, int j) {
        const Steadiness::Pixel& pixel = steadiness.at(i, j);
        if (pixel.level == 0 || now.seconds - pixel.since.seconds < options_.stay) return false;
        since.push_back(pixel.since);
        return true;
    });
    for_each_pixel(patch_, [&](int i, int j, std::uint8_t) {
        patch_.values.at(i - patch_.box.left, j - patch_.box.top) = steadiness.at(i, j).level;
    });
    still_since_ = nearly_last_of(std::move(since));
    Moment still = still_since_;
    if (out_of_another) {
        // What was seen of it before was its bearer.
        first_ = still;
        box_ = patch_.box;
        path_ = Path();
        path_.add(first_, patch_.centre);
        stays_ = Stays(options_.stay);
    } else if (still.frame < first_.frame) {
        still = first_;
    }
    stands_ = true;
    settled_ = true;
    velocity_ = {};
    shift_ = {};
    recent_.clear();
    stay_ = {still, now, patch_.centre, patch_.box};
    see_standing(now);
}

bool Track::belongs_to(const Track& other, int reach) const {
    return patch_.box.grown(reach, reach).meets(other.patch_.box) &&
           std::abs(still_since_.seconds - other.still_since_.seconds) <= options_.stay;
}

void Track::add_part(const Track& part) {
    const PixelBox box = hull_of(patch_.box, part.patch_.box);
    Patch whole{.box = box, .values = Plane<std::uint8_t>({box.width(), box.height()}), .area = 0, .centre = {}};
    for (int j = box.top; j < box.bottom; ++j) {
        for (int i = box.left; i < box.right; ++i) {
            const std::uint8_t value = std::max(patch_.at(i, j), part.patch_.at(i, j));
            if (value == 0) continue;
            whole.values.at(i - box.left, j - box.top) = value;
            whole.centre += glm::dvec2(i, j);
            ++whole.area;
        }
    }
    whole.centre /= std::max(1, whole.area);
    patch_ = std::move(whole);
    box_ = hull_of(box_, box);
    stay_.place = patch_.centre;
    stay_.box = box;
}

double Track::visible_part(const Plane<std::uint8_t>& field) const {
    return like(patch_, {0, 0}, field);
}

void Track::see_standing(const Moment& now) {
    stay_.last = now;
    went_on(now, patch_.box, patch_.centre);
}

void Track::end_stay() {
    if (!stands_) return;
    stays_.add_exactly(stay_);
    stands_ = false;
}

void Track::rise() {
    end_stay();
}

void Track::join(const Track& piece) {
    if (piece.first_.frame < first_.frame) first_ = piece.first_;
    box_ = hull_of(box_, piece.box_);
}

Event Track::finish() {
    end_stay();
    Event event{first_, seen_, box_, path_.points(), 0, stays_.finish(), {}, {}};
    event.path_length = length_of(event.path);
    return event;
}

}  // namespace vvr
