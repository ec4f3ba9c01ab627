#include "core/tracking/event_finder.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <opencv2/core.hpp>

#include "core/base/cv_view.h"

namespace vvr::tracking {

namespace {

/// Whether any pixel of `b` lies within `reach` of the box of `a`.
bool touches(const Patch& a, const Patch& b, int reach) {
    const PixelBox both = intersection(a.box.inflated(reach, reach), b.box);
    for (int j = both.top; j < both.bottom; ++j) {
        for (int i = both.left; i < both.right; ++i) {
            if (b.at(i, j) != 0) return true;
        }
    }
    return false;
}

/// Data files have pictures in colour only.
Plane<std::uint8_t> brightness_of(const Plane<Bgr>& colour) {
    Plane<std::uint8_t> grey(colour.size());
    std::ranges::transform(colour.pixels(), grey.pixels().begin(),
                           [](const Bgr& pixel) { return static_cast<std::uint8_t>(fields::brightness_of(pixel)); });
    return grey;
}

}  // namespace

EventFinder::EventFinder(Size field, const EventOptions& options)
    : options_(options),
      field_(field),
      reach_(std::max(1, std::max(field.width, field.height) / thresholds.blob.reach)),
      min_area_(field.width * field.height / thresholds.blob.area) {}

TrackedFrame EventFinder::add(const FrameView& sight, const Moment& now) {
    if (next_frame_++ == 0) first_ = now;
    if (stretches_.empty() || follows_gap(now) || sight.view != view_) {
        restart();
        stretches_.push_back({now, now, sight.view});
        view_ = sight.view;
    }
    if (sight.new_scene != nullptr) scenes_[view_] = sight.new_scene->planes;
    if (sight.damaged) {
        const bool goes_on = !damaged_.empty() && damaged_.back().end == last_.seconds;
        if (!goes_on) damaged_.push_back({now.seconds, now.seconds, condition::Kind::damaged});
        damaged_.back().end = now.seconds;
    }
    last_ = stretches_.back().last = now;
    record_share(sight.field, now);
    clocks_.add(sight.grey.empty() ? brightness_of(sight.colour) : sight.grey, now);
    steadiness_.add(sight.field, now);
    flicker_.add(sight.field, now);
    Blobs blobs = find_blobs(without_stationary(sight, now), {std::max(1, reach_ / 2), 2 * reach_}, min_area_);
    std::vector<Appearance> appearances;
    for (const Patch& patch : blobs.patches) appearances.emplace_back(patch, sight);
    Assignment assignment = associate_movers(blobs, appearances, now);
    merge_fragments(blobs, appearances, assignment, sight);
    track_occluded(sight, blobs, appearances, assignment, now);
    for (auto& chosen : assignment.tracks) drop_unconfirmed(chosen);
    update_tracks(sight, blobs, appearances, assignment, now);
    settle(sight, now);
    TrackedFrame frame = tracked(now);
    std::erase_if(tracks_, [](const Track& track) { return track.is<Ended>(); });
    return frame;
}

/// Whether there is a gap before this frame. Lost frames leave out numbers; a low frame rate does not.
bool EventFinder::follows_gap(const Moment& now) const {
    return now.frame > last_.frame + 1 && now.seconds - last_.seconds >= thresholds.track.lost_after;
}

void EventFinder::restart() {
    for (Track& track : tracks_) end(track, false, last_);
    tracks_.clear();
    steadiness_ = {};
}

/// The field without the camera's clock and without the stationary objects, which it also updates.
Plane<std::uint8_t> EventFinder::without_stationary(const FrameView& sight, const Moment& now) {
    const Plane<std::uint8_t>& field = sight.field;
    Plane<std::uint8_t> rest = field;
    for (const PixelBox& clock : clocks_.found()) fill(rest, clock, 0);
    for (Track& track : tracks_) {
        Standing* const standing = track.standing();
        if (standing == nullptr) continue;
        const double part = track.visible_part(field);
        if (part < thresholds.most) {
            standing->alone_at.reset();
            continue;
        }
        const bool whole = part >= thresholds.stationary.undisturbed;
        standing->uncovered.reset();
        track.update_stationary(sight, scene(), now, whole, about(track).has_value());
        // The rim of an object is never quite still. If somebody is near, the rim may be theirs, and stays.
        const int rim = whole ? reach_ + 1 : 0;
        for_each_pixel(track.patch(), [&](int i, int j, std::uint8_t value) {
            if (rim == 0 && !Steadiness::alike(field.at(i, j), value)) return;
            for (int y = std::max(0, j - rim); y <= std::min(field.height() - 1, j + rim); ++y) {
                for (int x = std::max(0, i - rim); x <= std::min(field.width() - 1, i + rim); ++x) rest.at(x, y) = 0;
            }
        });
    }
    return rest;
}

/// Associates blobs with all tracks that follow blobs. The result has indices in `tracks_`.
Assignment EventFinder::associate_movers(const Blobs& blobs, std::span<const Appearance> appearances,
                                         const Moment& now) const {
    std::vector<std::size_t> movers;
    std::vector<PredictedTrack> expected;
    for (std::size_t k = 0; k < tracks_.size(); ++k) {
        const Track& track = tracks_[k];
        if (!track.follows_blobs()) continue;
        movers.push_back(k);
        expected.push_back(
            {&track.patch(), track.shift_at(now), &track.appearance(), track.is<Merged>(), track.usual_size()});
    }
    Assignment assignment = associate(expected, blobs, appearances);
    for (auto& chosen : assignment.tracks) {
        for (std::size_t& k : chosen) k = movers[k];
    }
    for (auto* places : {&assignment.fragment_of, &assignment.split_from}) {
        for (auto& k : *places) {
            if (k) k = movers[*k];
        }
    }
    return assignment;
}

void EventFinder::merge_fragments(Blobs& blobs, std::vector<Appearance>& appearances, const Assignment& assignment,
                                  const FrameView& sight) {
    for (std::size_t b = 0; b < blobs.patches.size(); ++b) {
        if (!assignment.fragment_of[b]) continue;
        const auto home = std::ranges::find_if(assignment.tracks, [&](const auto& chosen) {
            return chosen.size() == 1 && chosen.front() == *assignment.fragment_of[b];
        });
        const auto place = static_cast<std::size_t>(home - assignment.tracks.begin());
        blobs.patches[place] = joined(blobs.patches[place], blobs.patches[b]);
        appearances[place] = Appearance(blobs.patches[place], sight);
    }
}

/// Handles stationary objects that are not visible now: each is occluded, was taken, or moves again.
void EventFinder::track_occluded(const FrameView& sight, Blobs& blobs, std::vector<Appearance>& appearances,
                                 Assignment& assignment, const Moment& now) {
    for (std::size_t k = 0; k < tracks_.size(); ++k) {
        Track& track = tracks_[k];
        Standing* const standing = track.standing();
        if (standing == nullptr || track.seen().frame == now.frame) continue;
        if (!standing->near) standing->near = about(track);
        if (!standing->near) standing->near = bystander(track);
        if (!standing->near && moves_again(k, blobs, appearances, assignment, sight, now)) continue;
        int covered = 0;
        for_each_pixel(track.patch(),
                       [&](int i, int j, std::uint8_t) { covered += sight.field.at(i, j) != 0 ? 1 : 0; });
        const bool uncovered = 2 * covered < track.patch().area;
        if (uncovered && !standing->uncovered) standing->uncovered = now;
        const bool gone = uncovered && now.seconds - standing->uncovered->seconds >= thresholds.track.lost_after;
        if (gone || now.seconds - track.seen().seconds > thresholds.memory) end(track, true, now);
    }
}

/// Lets a stationary object move again if only it and pieces of it are there. All these blobs become the object.
bool EventFinder::moves_again(std::size_t k, Blobs& blobs, std::vector<Appearance>& appearances, Assignment& assignment,
                              const FrameView& sight, const Moment& now) {
    const std::size_t number = tracks_[k].number();
    const auto is_own = [&](std::size_t other) { return tracks_[other].from() == number; };
    const std::vector<int> overlap = overlaps_of(tracks_[k].patch(), {}, blobs);
    std::vector<std::size_t> own;
    for (std::size_t b = 0; b < blobs.patches.size(); ++b) {
        const auto& chosen = assignment.tracks[b];
        const bool any = chosen.empty() ? overlap[b] > 0 : std::ranges::all_of(chosen, is_own);
        if (any && !assignment.fragment_of[b]) own.push_back(b);
    }
    if (own.empty()) return false;
    if (tracks_[k].shows_scene(scene())) {
        end(tracks_[k], false, now);
        return true;
    }
    const std::size_t place = *std::ranges::max_element(own, {}, [&](std::size_t b) { return blobs.patches[b].area; });
    for (const std::size_t b : own) {
        for (const std::size_t piece : assignment.tracks[b]) tracks_[piece].end();
        assignment.tracks[b].clear();
        if (b == place) continue;
        blobs.patches[place] = joined(blobs.patches[place], blobs.patches[b]);
        assignment.fragment_of[b] = k;
    }
    appearances[place] = Appearance(blobs.patches[place], sight);
    tracks_[k].move_again(now);
    assignment.tracks[place] = {k};
    return true;
}

/// The number of a moving object beside a stationary one.
std::optional<std::size_t> EventFinder::about(const Track& standing) const {
    const PixelBox& box = standing.patch().box;
    const PixelBox wide = box.inflated(box.width(), box.height());
    for (const Track& track : tracks_) {
        const bool own = track.from() == standing.number();
        if (!own && track.follows_blobs() && track.is_confirmed() && wide.intersects(track.patch().box)) {
            return track.number();
        }
    }
    return std::nullopt;
}

/// The number of somebody who came to a thing and stands beside it. If it moves now, it doesn't move by itself.
std::optional<std::size_t> EventFinder::bystander(const Track& thing) const {
    if (!thing.found_standing()) return std::nullopt;
    const PixelBox& box = thing.patch().box;
    const PixelBox wide = box.inflated(box.width(), box.height());
    for (const Track& track : tracks_) {
        const bool came =
            track.is<Standing>() && !track.found_standing() && track.first().frame > thing.still_since().frame;
        const bool larger = thing.patch().area <= thresholds.most * track.usual_area();
        if (came && larger && wide.intersects(track.patch().box)) return track.number();
    }
    return std::nullopt;
}

/// Drops short-lived tracks that now share a blob with another: they are fragments of it.
void EventFinder::drop_unconfirmed(std::vector<std::size_t>& chosen) {
    if (chosen.size() < 2) return;
    const auto whole = *std::ranges::max_element(
        chosen, {}, [&](std::size_t k) { return std::pair(tracks_[k].is_confirmed(), tracks_[k].patch().area); });
    std::erase_if(chosen, [&](std::size_t k) {
        Track& piece = tracks_[k];
        if (k == whole || piece.is_confirmed()) return false;
        // An object that has just entered at the border is no fragment of one that leaves there.
        if (tracks_[whole].is_confirmed() && piece.entered_at_border()) return false;
        if (!tracks_[whole].is_confirmed()) tracks_[whole].join(piece);
        piece.end();
        return true;
    });
}

void EventFinder::update_tracks(const FrameView& sight, const Blobs& blobs, std::span<const Appearance> appearances,
                                const Assignment& assignment, const Moment& now) {
    std::vector<bool> went_on(tracks_.size());
    std::vector<Track> begun;
    for (std::size_t b = 0; b < blobs.patches.size(); ++b) {
        const auto& chosen = assignment.tracks[b];
        for (const std::size_t k : chosen) went_on[k] = true;
        if (chosen.size() > 1) {
            share(blobs.patches[b], chosen, sight, now);
            continue;
        }
        if (chosen.size() == 1) {
            tracks_[chosen.front()].update(blobs.patches[b], appearances[b], sight, scene(), now);
            continue;
        }
        if (assignment.fragment_of[b]) continue;
        begin(blobs.patches[b], appearances[b], assignment.split_from[b], begun, sight, now);
    }
    for (std::size_t k = 0; k < went_on.size(); ++k) {
        Track& track = tracks_[k];
        if (went_on[k] || !track.follows_blobs()) continue;
        track.coast(now);
        // Whose place is lost within a shared blob is still in it.
        if (now.seconds - track.seen().seconds > thresholds.track.lost_after) end(track, track.is<Merged>(), now);
    }
    std::ranges::move(begun, std::back_inserter(tracks_));
}

/// Begins a track with a blob.
/// \param parent index of the track from which it split
void EventFinder::begin(const Patch& blob, const Appearance& appearance, std::optional<std::size_t> parent,
                        std::vector<Track>& begun, const FrameView& sight, const Moment& now) {
    auto from = parent ? std::optional(tracks_[*parent].number()) : std::nullopt;
    for (const Track& track : tracks_) {
        // A fragment of a fragment belongs to the whole object.
        const bool own = !parent || tracks_[*parent].from() == track.number();
        if (own && track.is<Standing>() && touches(blob, track.patch(), 2 * reach_ + 2)) from = track.number();
    }
    Origin origin{from};
    if (parent) {
        origin.area = tracks_[*parent].usual_area();
        origin.was_alone = tracks_[*parent].is<Moving>();
    }
    begun.emplace_back(next_++, origin, field_).update(blob, appearance, sight, scene(), now);
}

/// Finds each of several tracks within their shared blob.
void EventFinder::share(const Patch& blob, std::span<const std::size_t> chosen, const FrameView& sight,
                        const Moment& now) {
    std::vector<const Template*> templates;
    std::vector<glm::ivec2> expected;
    double largest = 0;
    for (const std::size_t k : chosen) {
        largest = std::max(largest, tracks_[k].current_area());
        templates.push_back(&tracks_[k].appearance_template());
        expected.push_back(tracks_[k].template_shift_at(now));
    }
    const std::vector<TemplateMatch> shares = split_blob(blob, sight, templates, expected);
    for (std::size_t n = 0; n < chosen.size(); ++n) {
        Track& track = tracks_[chosen[n]];
        track.merge(tracks_[chosen[n == 0 ? chosen.size() - 1 : 0]].number());
        // A small object matches any part of a person.
        if (track.current_area() < thresholds.merged.searched * largest) {
            track.coast(now);
            if (now.seconds - track.seen().seconds > thresholds.track.lost_after) end(track, true, now);
            continue;
        }
        const bool found = track.update_merged(shares[n], blob, sight, now);
        if (track.is_outside()) end(track, false, now);
        if (!found && now.seconds - track.seen().seconds > thresholds.merged.occluded_after) end(track, true, now);
    }
}

/// If the track left the picture shortly before, ends it, and goes on with the thing that it left behind.
void EventFinder::part_with_bearer(Track& track, const FrameView& sight, const Moment& now) {
    const std::optional<Tracklet>& bearer = track.departed();
    if (!bearer || now.seconds - bearer->end.at.seconds > 2 * thresholds.stationary.stay) return;
    Track thing(next_++, {bearer->number, bearer->area, true}, field_);
    thing.update(track.patch(), Appearance(track.patch(), sight), sight, scene(), now);
    keep(*bearer);
    track = std::move(thing);
}

void EventFinder::settle(const FrameView& sight, const Moment& now) {
    for (Track& track : tracks_) {
        if (!track.is<Moving>() || track.seen().frame != now.frame) continue;
        if (!track.has_settled(steadiness_, flicker_, now)) continue;
        part_with_bearer(track, sight, now);
        track.settle(steadiness_, flicker_, sight, scene(), now);
        track.set_changed(share_at(track.still_since()));
        merge_stationary(track);
    }
}

/// Merges stationary parts of one object, which came to rest separately because some were occluded. The better known
/// track stays.
void EventFinder::merge_stationary(Track& part) {
    for (Track& other : tracks_) {
        if (&other == &part || !other.is<Standing>() || !part.belongs_to(other)) continue;
        const bool is_whole = part.first().frame < other.first().frame && part.usual_area() > other.usual_area();
        Track& whole = is_whole ? part : other;
        Track& rest = is_whole ? other : part;
        whole.add_part(rest);
        rest.end();
        if (!is_whole) return;
    }
}

void EventFinder::end(Track& track, bool taken, const Moment& now) {
    if (track.is<Ended>()) return;
    keep(track.tracklet(taken, scene(), now));
    track.end();
}

void EventFinder::keep(Tracklet tracklet) {
    tracklet.stretch = stretches_.size() - 1;
    // Tracklets of rain and leaves are dropped: in a stream of days they would fill the memory.
    const bool jumps = !tracklet.settled && tracklet.continuous < thresholds.event.continuous;
    if (tracklet.is_confirmed() && !jumps) ended_.push_back(std::move(tracklet));
}

bool EventFinder::follows(std::span<const std::size_t> tracks) const {
    return std::ranges::any_of(tracks_, [&](const Track& track) {
        return !track.is<Ended>() && std::ranges::find(tracks, track.number()) != tracks.end();
    });
}

TrackedFrame EventFinder::tracked(const Moment& now) const {
    TrackedFrame frame{{now, {}}, {}, {}};
    for (const Track& track : tracks_) {
        if (options_.labels && !track.is<Ended>() && track.seen().frame == now.frame) {
            add_runs(track.pixels(), track.number(), frame.labels);
        }
        const auto since = track.busy_since(now);
        if (since) frame.busy_since = std::min(frame.busy_since.value_or(*since), *since);
        const std::optional<Portrait>& portrait = track.portrait();
        if (portrait && portrait->at.frame == now.frame) frame.portraits.push_back({track.number(), *portrait});
    }
    return frame;
}

/// Records the share of the picture that differs from the empty scene.
void EventFinder::record_share(const Plane<std::uint8_t>& field, const Moment& now) {
    const int differs = cv::countNonZero(cv_view(field));
    const double share = differs / std::max<double>(1, static_cast<double>(field.pixels().size()));
    if (largest_shares_.empty() || now.seconds - largest_shares_.back().first >= 1) {
        largest_shares_.emplace_back(now.seconds, share);
    } else {
        largest_shares_.back().second = std::max(largest_shares_.back().second, share);
    }
    shares_.emplace_back(now.seconds, share);
    while (now.seconds - shares_.front().first > thresholds.memory) shares_.pop_front();
}

/// The largest share of the picture that differed within a second of a moment.
double EventFinder::share_at(const Moment& moment) const {
    double largest = 0;
    for (const auto& [seconds, share] : shares_) {
        if (std::abs(seconds - moment.seconds) <= 1) largest = std::max(largest, share);
    }
    return largest;
}

Findings EventFinder::finish() {
    clocks_.finish();
    for (Track& track : tracks_) end(track, false, last_);
    tracks_.clear();
    Findings found =
        conclude(std::move(ended_), {field_, first_, last_, stretches_, clocks_.found(), damaged_}, options_);
    found.largest_share = largest_share_since(first_.seconds);
    return found;
}

void EventFinder::forget_ended_before(double seconds, const std::set<std::size_t>& needed) {
    std::erase_if(ended_, [&](const Tracklet& tracklet) {
        return tracklet.end.at.seconds < seconds && !needed.contains(tracklet.number);
    });
    std::erase_if(largest_shares_, [&](const auto& second) { return second.first < seconds; });
}

double EventFinder::largest_share_since(double seconds) const {
    double largest = 0;
    for (const auto& [begin, share] : largest_shares_) {
        if (begin >= seconds) largest = std::max(largest, share);
    }
    return largest;
}

}  // namespace vvr::tracking
