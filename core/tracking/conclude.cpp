#include "core/tracking/conclude.h"

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "core/tracking/claim.h"
#include "core/tracking/patch.h"
#include "core/tracking/path.h"

namespace vvr::tracking {

namespace {

/// An object that may be an event.
struct Candidate {
    std::vector<std::size_t> tracks;
    Tracklet whole;
    Signs signs{};
    EventKind kind = EventKind::moved;
    bool wanted = true;
    bool is_claim = false;                // nobody saw it move: the evidence decides
    bool carried = false;                 // somebody was there to bring or take it
    std::optional<std::size_t> beside{};  // number of whoever was beside it then, if it split from nobody
    bool from_first = false;              // it was there when its stretch began
    bool to_last = false;
};

/// How little an object is of what it came out of, 0 to 1.
double part_of(const Tracklet& tracklet) {
    if (!tracklet.from) return 0;
    return tracklet.area_of_parent > 0 ? std::max(0.0, 1 - tracklet.area / tracklet.area_of_parent) : 1;
}

Signs signs_of(const Tracklet& tracklet, Size field) {
    return {std::max(0.0, tracklet.difference.texture),
            std::max(-0.5, straightness_of(tracklet.path)),
            std::log(std::clamp(tracklet.seconds(), 0.1, 20.0)),
            std::log(std::max(1e-4, tracklet.area / field.width / field.height)),
            tracklet.seen,
            part_of(tracklet),
            tracklet.settled ? 1.0 : 0.0};
}

bool has_moved(const Tracklet& tracklet) {
    return tracklet.moved >= thresholds.event.own_lengths * tracklet.length;
}

bool is_likely(const Candidate& candidate) {
    return probability_of(candidate.signs) >= thresholds.event.probability;
}

class Conclusion {
  public:
    Conclusion(Trajectories trajectories, const Span& span, const EventOptions& options)
        : span_(span), options_(options), object_of_(std::move(trajectories.of_track)) {
        for (Trajectory& one : trajectories.all) {
            candidates_.push_back({std::move(one.tracks), std::move(one.whole)});
        }
    }

    Findings run() {
        found_.overlays = span_.overlays;
        for (const Stretch& stretch : span_.stretches) found_.begins.push_back(stretch.first);
        look_at_ends();
        for (Candidate& candidate : candidates_) judge(candidate);
        absorb_fragments();
        for (std::size_t k = 0; k < candidates_.size(); ++k) {
            find_carrier(k);
            if (was_never_alone(k)) candidates_[k].wanted = false;
            weigh(k);
        }
        found_.events = listed();
        std::ranges::stable_sort(found_.changes, {}, [](const Change& change) { return change.first.frame; });
        return std::move(found_);
    }

  private:
    const Stretch& stretch_of(const Tracklet& tracklet) const { return span_.stretches[tracklet.stretch]; }

    /// The stretch before, if there is one. Those of another view show another scene, and don't count.
    std::optional<std::size_t> stretch_before(const Tracklet& tracklet) const {
        for (std::size_t k = tracklet.stretch; k > 0; --k) {
            if (span_.stretches[k - 1].view == stretch_of(tracklet).view) return k - 1;
        }
        return std::nullopt;
    }

    /// Whether it was there when its stretch began. Then nobody knows what it did before.
    bool was_there_first(const Tracklet& tracklet) const {
        return tracklet.begin.at.seconds - stretch_of(tracklet).first.seconds < thresholds.stationary.stay;
    }

    /// Whether it was there until its stretch ended. Then nobody knows how long it stayed.
    bool lasts_to_end(const Candidate& candidate) const {
        const Tracklet& tracklet = candidate.whole;
        const double unseen = stretch_of(tracklet).last.seconds - tracklet.end.at.seconds;
        const bool is_lost =
            unseen > 0 && (tracklet.end.at_border || tracklet.into || unseen >= thresholds.track.lost_after);
        // If the fields don't show it, `to_last` is about its ghost.
        return !is_lost || (candidate.to_last && !tracklet.in_scene);
    }

    /// Whether it is digits of the camera's clock.
    bool is_overlay(const PixelBox& box) const {
        return std::ranges::any_of(span_.overlays, [&](const PixelBox& clock) { return is_mostly_inside(box, clock); });
    }

    /// Marks objects at the first and last moment of their stretch, before ghosts are corrected.
    void look_at_ends() {
        in_stretch_.resize(span_.stretches.size());
        for (std::size_t k = 0; k < candidates_.size(); ++k) {
            Candidate& candidate = candidates_[k];
            const Tracklet& tracklet = candidate.whole;
            candidate.from_first = was_there_first(tracklet);
            candidate.to_last = tracklet.stood_to_end && stretch_of(tracklet).last.seconds - tracklet.end.at.seconds <
                                                             thresholds.stationary.stay;
            in_stretch_[tracklet.stretch].push_back(k);
        }
    }

    /// Whether something stood at the same place at the end of a stretch.
    /// \param from_first it must also have stood there at the beginning
    bool stood_in(std::size_t stretch, const Tracklet& tracklet, bool from_first) const {
        return std::ranges::any_of(in_stretch_[stretch], [&](std::size_t k) {
            const Candidate& other = candidates_[k];
            return other.to_last && (!from_first || other.from_first) && is_at_same_place(other.whole, tracklet);
        });
    }

    static bool is_at_same_place(const Tracklet& a, const Tracklet& b) {
        if (!a.settled || !b.settled) return false;
        const double off = glm::distance(a.settled->patch.centre, b.settled->patch.centre);
        return off < thresholds.stationary.apart * std::max(thresholds.least_length, b.length);
    }

    /// Whether it stood there in all frames of all stretches of this view that are long enough to tell.
    bool was_always_there(const Candidate& candidate) const {
        if (candidate.whole.stays.size() > 1) return false;
        if (has_moved(candidate.whole) || !candidate.from_first || !candidate.to_last) return false;
        for (std::size_t k = 0; k < span_.stretches.size(); ++k) {
            const Stretch& stretch = span_.stretches[k];
            if (stretch.view != stretch_of(candidate.whole).view) continue;
            const bool can_settle = stretch.last.seconds - stretch.first.seconds >= 2 * thresholds.stationary.stay;
            if (k != candidate.whole.stretch && can_settle && !stood_in(k, candidate.whole, true)) return false;
        }
        return true;
    }

    /// Whether pictures were damaged for most of a time, or at its ends. What a decoder makes up keeps still.
    bool was_damaged(double begin, double end) const {
        double damaged = 0;
        for (const condition::Interval& some : span_.damaged)
            damaged += std::max(0.0, std::min(end, some.end) - std::max(begin, some.begin));
        return damaged > 0 && 2 * damaged >= end - begin;
    }

    void judge(Candidate& candidate) {
        Tracklet& tracklet = candidate.whole;
        std::erase_if(tracklet.stays,
                      [this](const Stay& stay) { return was_damaged(stay.first.seconds, stay.last.seconds); });
        const bool stands_only = tracklet.settled && tracklet.stood_from_start;
        candidate.wanted =
            tracklet.is_confirmed() && (has_moved(tracklet) || tracklet.settled) && !is_overlay(tracklet.box);
        if (!candidate.wanted) return;
        candidate.signs = signs_of(tracklet, span_.field);
        if (tracklet.difference.novelty < thresholds.claim.novelty || (!stands_only && !is_likely(candidate))) {
            demote_to_change(candidate);
            return;
        }
        if (!stands_only) {
            candidate.kind = tracklet.stays.empty() ? EventKind::moved : EventKind::stood;
            return;
        }
        candidate.is_claim = true;
        constexpr double around = 0.5;  // seconds
        const double begin = tracklet.begin.at.seconds;
        if (was_damaged(begin - around, begin + around)) {
            demote_to_change(candidate);
            return;
        }
        // If the camera shakes, the empty scene is blurred at places, and its edges say nothing.
        if (options_.scene_is_learnt && was_always_there(candidate)) candidate.wanted = false;
        if (is_ghost(tracklet)) {
            judge_ghost(candidate);
        } else {
            // Nobody saw it come.
            candidate.kind = candidate.from_first ? EventKind::stood : EventKind::left;
        }
    }

    static bool is_ghost(const Tracklet& tracklet) {
        return tracklet.settled && tracklet.stood_from_start &&
               tracklet.settled->evidence.edges < tracklet.settled->evidence.scene_edges;
    }

    /// The next ghost at the place of another in the same stretch: when it begins, the thing that the empty scene has
    /// is gone again.
    const Tracklet* next_ghost(const Tracklet& tracklet) const {
        const Tracklet* next = nullptr;
        for (const std::size_t k : in_stretch_[tracklet.stretch]) {
            const Tracklet& other = candidates_[k].whole;
            if (!is_ghost(other) || other.begin.at.frame <= tracklet.gone.frame || !is_at_same_place(other, tracklet))
                continue;
            if (next == nullptr || other.begin.at.frame < next->begin.at.frame) next = &other;
        }
        return next;
    }

    /// Decides what a ghost means: the empty scene has a thing that the frames don't have.
    void judge_ghost(Candidate& candidate) {
        Tracklet& tracklet = candidate.whole;
        candidate.kind = EventKind::taken;
        const std::optional<std::size_t> before = stretch_before(tracklet);
        const bool was_never_there = candidate.from_first && (!before || stood_in(*before, tracklet, false));
        if (!was_never_there) {
            tracklet.stays.clear();
            return;
        }
        // The empty scene is of later frames: the thing was put down when the ghost ended.
        candidate.kind = EventKind::left;
        tracklet.in_scene = true;
        const Tracklet* const next = next_ghost(tracklet);
        tracklet.begin.at = tracklet.gone;
        tracklet.end.at = next != nullptr ? next->begin.at : stretch_of(tracklet).last;
        if (tracklet.seconds() < thresholds.stationary.stay) candidate.wanted = false;
        tracklet.from = tracklet.into;
        tracklet.into.reset();
        tracklet.path = {{tracklet.begin.at, tracklet.settled->patch.centre},
                         {tracklet.end.at, tracklet.settled->patch.centre}};
        tracklet.box = tracklet.settled->patch.box;
        tracklet.stays = {{tracklet.begin.at, tracklet.end.at, tracklet.settled->patch.centre, tracklet.box}};
        tracklet.portrait.reset();
    }

    void absorb_fragments() {
        std::vector<std::size_t> order(candidates_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto size_of = [&](std::size_t k) {
            const Tracklet& tracklet = candidates_[k].whole;
            return tracklet.settled ? std::max<double>(tracklet.area, tracklet.settled->patch.area) : tracklet.area;
        };
        std::ranges::sort(order, std::greater{}, size_of);
        for (std::size_t a = 0; a < order.size(); ++a) {
            const Candidate& whole = candidates_[order[a]];
            if (!whole.wanted) continue;
            for (std::size_t b = a + 1; b < order.size(); ++b) {
                Candidate& piece = candidates_[order[b]];
                const bool apart = piece.whole.begin.at.frame > whole.whole.end.at.frame ||
                                   piece.whole.end.at.frame < whole.whole.begin.at.frame;
                if (apart) continue;
                const bool small = size_of(order[b]) <= thresholds.most * size_of(order[a]);
                if (!piece.wanted || (!small && !piece.whole.stood_from_start)) continue;
                if (is_fragment_of(piece.whole, whole.whole)) piece.wanted = false;
            }
        }
    }

    /// Whether it was there when the clip began, or was an event before the gap at which its stretch began. Anything
    /// else that is new after a gap may be a change of light or of the camera's view.
    bool was_there_before(const Tracklet& tracklet) const {
        if (!was_there_first(tracklet)) return false;
        const std::optional<std::size_t> before = stretch_before(tracklet);
        return !before || std::ranges::any_of(in_stretch_[*before], [&](std::size_t k) {
            return candidates_[k].wanted && candidates_[k].to_last && is_at_same_place(candidates_[k].whole, tracklet);
        });
    }

    /// Finds who put a thing down or took it. A thing that appears with nobody beside it is light, a caption or a
    /// codec's artefact.
    void find_carrier(std::size_t k) {
        Candidate& candidate = candidates_[k];
        Tracklet& tracklet = candidate.whole;
        if (!candidate.wanted || !candidate.is_claim) return;
        if (was_there_first(tracklet)) {
            candidate.carried = was_there_before(tracklet);
            return;
        }
        if (const auto parent = tracklet.from ? object_of_.find(*tracklet.from) : object_of_.end();
            parent != object_of_.end()) {
            const Candidate& bearer = candidates_[parent->second];
            candidate.carried = bearer.wanted && can_carry(bearer.whole, tracklet, candidate.kind, span_.field);
            return;
        }
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t other = 0; other < candidates_.size(); ++other) {
            const Tracklet& bearer = candidates_[other].whole;
            if (other == k || !candidates_[other].wanted || bearer.stood_from_start ||
                !can_carry(bearer, tracklet, candidate.kind, span_.field))
                continue;
            if (!was_beside(bearer, tracklet, span_.seconds_per_frame())) continue;
            candidate.carried = true;
            const double away =
                glm::distance(place_at(bearer.path, tracklet.begin.at.frame), tracklet.settled->patch.centre);
            if (away >= nearest) continue;
            nearest = away;
            candidate.beside = bearer.number;
        }
    }

    /// The seconds for which nobody was near a thing that the fields don't show, as the empty scene has it.
    double alone_in_scene(std::size_t k) const {
        constexpr double step = 0.5;
        const Tracklet& tracklet = candidates_[k].whole;
        double alone = 0;
        const double last = std::min(tracklet.end.at.seconds, tracklet.begin.at.seconds + thresholds.memory);
        for (double seconds = tracklet.begin.at.seconds; seconds < last; seconds += step) {
            const double frames = (seconds - tracklet.begin.at.seconds) / span_.seconds_per_frame();
            const std::int64_t frame = tracklet.begin.at.frame + std::llround(frames);
            bool near = false;
            for (std::size_t other = 0; other < candidates_.size() && !near; ++other) {
                if (other == k || !candidates_[other].wanted) continue;
                near = is_near(box_at(candidates_[other].whole, seconds, frame), tracklet.settled->patch.box);
            }
            if (!near) alone += step;
        }
        return alone;
    }

    /// Says of a claim how sure it is. With less evidence the place was changed, and with too little it is a change
    /// only. What moved by itself before it became still is no thing: it stood.
    void weigh(std::size_t k) {
        Candidate& candidate = candidates_[k];
        if (!candidate.wanted || !candidate.is_claim) return;
        Evidence& evidence = candidate.whole.settled->evidence;
        if (candidate.whole.in_scene) evidence.alone = alone_in_scene(k);
        if (candidate.kind == EventKind::left && evidence.moved >= 2 * thresholds.claim.moved) {
            candidate.kind = EventKind::stood;
            evidence.moved = 0;
        }
        evidence.carried = candidate.carried;
        evidence.novelty = candidate.whole.difference.novelty;
        evidence.confidence = confidence_of(evidence);
        const bool inside = !touches_border(candidate.whole.settled->patch.box, span_.field);
        if (evidence.confidence >= 0.5 && inside) return;
        const bool was_touched = row_of(candidate.kind).is_thing && !candidate.from_first &&
                                 evidence.alone >= thresholds.bearer &&
                                 evidence.confidence >= thresholds.claim.uncertain;
        if (was_touched && inside) {
            Tracklet& tracklet = candidate.whole;
            const Patch& patch = tracklet.settled->patch;
            candidate.kind = EventKind::changed;
            tracklet.stays = {{tracklet.begin.at, tracklet.end.at, patch.centre, patch.box}};
            return;
        }
        if (!candidate.from_first || is_ghost(candidate.whole) || !is_likely(candidate)) {
            demote_to_change(candidate);
            return;
        }
        candidate.kind = EventKind::stood;
    }

    /// Lists it as a change instead of an event.
    void demote_to_change(Candidate& candidate) {
        candidate.wanted = false;
        const Tracklet& tracklet = candidate.whole;
        const PixelBox& box = tracklet.settled ? tracklet.settled->patch.box : tracklet.box;
        Evidence evidence = tracklet.settled ? tracklet.settled->evidence : Evidence{};
        evidence.novelty = tracklet.difference.novelty;
        found_.changes.push_back({tracklet.begin.at, tracklet.end.at, box, evidence, candidate.signs});
    }

    /// Whether the bearer came, stayed within one length and left with the thing: then it is a part of the bearer.
    bool was_never_alone(std::size_t k) const {
        const Candidate& candidate = candidates_[k];
        const Tracklet& tracklet = candidate.whole;
        const std::optional<std::size_t> bringer = tracklet.from ? tracklet.from : candidate.beside;
        if (!candidate.wanted || candidate.kind != EventKind::left || !bringer || !tracklet.into) return false;
        const auto from = object_of_.find(*bringer);
        const auto into = object_of_.find(*tracklet.into);
        if (from == object_of_.end() || into == object_of_.end() || from->second != into->second) return false;
        const Tracklet& bearer = candidates_[from->second].whole;
        return std::ranges::none_of(bearer.path, [&](const PathPoint& point) {
            return point.at.frame >= tracklet.begin.at.frame && point.at.frame <= tracklet.end.at.frame &&
                   glm::distance(point.place, tracklet.settled->patch.centre) >= bearer.length;
        });
    }

    std::vector<Event> listed() {
        std::vector<std::size_t> order;
        for (std::size_t k = 0; k < candidates_.size(); ++k) {
            if (candidates_[k].wanted) order.push_back(k);
        }
        std::ranges::stable_sort(order, {}, [&](std::size_t k) {
            const Tracklet& tracklet = candidates_[k].whole;
            return std::pair(tracklet.begin.at.frame, tracklet.number);
        });
        std::map<std::size_t, std::size_t> places;
        for (std::size_t p = 0; p < order.size(); ++p) places[order[p]] = p;
        const auto place_of = [&](const std::optional<std::size_t>& number,
                                  std::size_t self) -> std::optional<std::size_t> {
            if (!number) return std::nullopt;
            const auto object = object_of_.find(*number);
            if (object == object_of_.end() || object->second == self) return std::nullopt;
            const auto place = places.find(object->second);
            return place == places.end() ? std::nullopt : std::optional(place->second);
        };
        std::vector<Event> events;
        events.reserve(order.size());
        for (const std::size_t k : order) {
            Candidate& candidate = candidates_[k];
            Tracklet& tracklet = candidate.whole;
            Event event;
            event.kind = candidate.kind;
            event.first = tracklet.begin.at;
            event.last = tracklet.end.at;
            event.box = intersection(tracklet.box, {0, 0, span_.field.width, span_.field.height});
            event.path = thinned(std::move(tracklet.path));
            event.path_length = length_of(event.path);
            event.stays = std::move(tracklet.stays);
            event.from = place_of(tracklet.from, k);
            event.into = place_of(tracklet.into, k);
            if (row_of(event.kind).is_thing) event.by = event.from ? event.from : place_of(candidate.beside, k);
            // The portrait of what was taken would show the place without it.
            if (!row_of(event.kind).is_of_scene) event.portrait = tracklet.portrait;
            event.open_ended = lasts_to_end(candidate);
            event.view = stretch_of(tracklet).view;
            event.signs = candidate.signs;
            if (tracklet.in_scene && tracklet.settled) {
                event.in_scene = ScenePatch{tracklet.settled->patch.box, tracklet.settled->patch.values};
            }
            if (candidate.is_claim) event.evidence = tracklet.settled->evidence;
            event.tracks = std::move(candidate.tracks);
            events.push_back(std::move(event));
        }
        for (std::size_t p = 0; p < events.size(); ++p) {
            Event& event = events[p];
            if (event.kind != EventKind::left || !event.by) continue;
            event.alone_since = alone_since(event, events[*event.by], candidates_[order[*event.by]].whole.length);
        }
        return events;
    }

    Span span_;
    EventOptions options_;
    Findings found_;
    std::vector<Candidate> candidates_;
    std::vector<std::vector<std::size_t>> in_stretch_;  // indices of the candidates in each stretch
    std::map<std::size_t, std::size_t> object_of_;      // from a track's number to the index of its candidate
};

}  // namespace

Findings conclude(std::vector<Tracklet> tracklets, const Span& span, const EventOptions& options) {
    return Conclusion(join(std::move(tracklets)), span, options).run();
}

}  // namespace vvr::tracking
