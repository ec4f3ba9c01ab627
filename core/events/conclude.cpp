#include "core/events/conclude.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "core/events/patch.h"
#include "core/events/path.h"
#include "core/events/tracklet.h"

namespace vvr::events {

namespace {

/// One object: its tracklets in order of time, and what is known of it.
struct Candidate {
    std::vector<std::size_t> parts;  // places of its tracklets
    Tracklet whole;
    EventKind kind = EventKind::moved;
    bool wanted = true;
    bool from_first = false;  // it was there when its stretch began
    bool to_last = false;     // and stood there to its end
};

/// What a standing thing is, by its edges.
enum class Evidence { there, gone, light };

class Conclusion {
  public:
    Conclusion(std::vector<Tracklet> tracklets, const Span& span, const fields::Planes& scene,
               const EventOptions& options)
        : tracklets_(std::move(tracklets)), span_(span), scene_(scene), options_(options) {}

    std::vector<Event> run() {
        join();
        look_at_ends();
        for (Candidate& candidate : candidates_) judge(candidate);
        absorb_fragments();
        for (std::size_t k = 0; k < candidates_.size(); ++k) {
            find_carrier(k);
            if (was_never_alone(k)) candidates_[k].wanted = false;
        }
        return listed();
    }

  private:
    void join() {
        std::ranges::stable_sort(tracklets_, {},
                                 [](const Tracklet& t) { return std::pair(t.begin.at.frame, t.number); });
        const auto next = link(tracklets_, options_);
        std::vector<bool> follows(tracklets_.size());
        for (const auto& n : next) {
            if (n) follows[*n] = true;
        }
        for (std::size_t k = 0; k < tracklets_.size(); ++k) {
            if (follows[k]) continue;
            Candidate candidate{{k}, tracklets_[k]};
            for (auto n = next[k]; n; n = next[*n]) {
                candidate.parts.push_back(*n);
                append(tracklets_[*n], candidate.whole);
            }
            for (const std::size_t part : candidate.parts) object_of_[tracklets_[part].number] = candidates_.size();
            candidates_.push_back(std::move(candidate));
        }
        for (std::size_t k = 0; k < candidates_.size(); ++k) begin_with_group(k);
    }

    static void append(const Tracklet& later, Tracklet& whole) {
        const double first_part = whole.seconds();
        const double later_part = later.seconds();
        const double all = std::max(1e-6, first_part + later_part);
        const auto mean = [&](double a, double b) { return (a * first_part + b * later_part) / all; };
        whole.seen = mean(whole.seen, later.seen);
        whole.flicker = mean(whole.flicker, later.flicker);
        whole.continuous = mean(whole.continuous, later.continuous);
        whole.area = mean(whole.area, later.area);
        whole.length = mean(whole.length, later.length);
        whole.size = glm::max(whole.size, later.size);
        whole.moved = std::max({whole.moved, later.moved, glm::distance(whole.begin.place, later.end.place)});
        whole.box = bounding_box(whole.box, later.box);
        while (!whole.path.empty() && whole.path.back().at.frame >= later.path.front().at.frame) {
            whole.path.pop_back();
            whole.areas.pop_back();
        }
        whole.path.insert(whole.path.end(), later.path.begin(), later.path.end());
        whole.areas.insert(whole.areas.end(), later.areas.begin(), later.areas.end());
        whole.stays.insert(whole.stays.end(), later.stays.begin(), later.stays.end());
        if (later.settled) whole.settled = later.settled;
        whole.stood_from_start = whole.stood_from_start && later.stood_from_start;
        if (later.portrait && (!whole.portrait || later.portrait->score > whole.portrait->score)) {
            whole.portrait = later.portrait;
        }
        whole.into = later.into;
        whole.end = later.end;
    }

    /// Two came as one and part: whoever got a new number then was there before, in the other's blob.
    void begin_with_group(std::size_t k) {
        Tracklet& own = candidates_[k].whole;
        if (!own.from || own.area_of_parent <= 0 || own.stood_from_start || own.seconds() < 2 * options_.least) return;
        const double times = own.area_of_parent / std::max(1.0, own.area);
        if (times < least_group || times > most_group) return;
        const auto found = object_of_.find(*own.from);
        if (found == object_of_.end() || found->second == k) return;
        const Tracklet& other = candidates_[found->second].whole;
        std::vector<PathPoint> before;
        for (std::size_t p = 0; p < other.path.size(); ++p) {
            if (other.path[p].at.frame >= own.begin.at.frame) break;
            before.push_back(other.path[p]);
            if (other.areas[p] > 0 && other.areas[p] < small_part * own.area_of_parent) before.clear();
        }
        if (before.empty()) return;
        own.path.insert(own.path.begin(), before.begin(), before.end());
        own.areas.insert(own.areas.begin(), before.size(), 0);
        own.begin.at = before.front().at;
        own.begin.place = before.front().place;
        own.from.reset();
        own.moved = std::max(own.moved, glm::distance(own.begin.place, own.end.place));
    }

    const Stretch& stretch_of(const Tracklet& own) const { return span_.stretches[own.stretch]; }

    /// Whether it was there when its stretch began: what it did before nobody knows.
    bool was_there_first(const Tracklet& own) const {
        return own.begin.at.seconds - stretch_of(own).first.seconds < options_.stay;
    }

    /// Marks what stands at the ends of its stretch, before ghosts are set right.
    void look_at_ends() {
        in_stretch_.resize(span_.stretches.size());
        for (std::size_t k = 0; k < candidates_.size(); ++k) {
            Candidate& candidate = candidates_[k];
            const Tracklet& own = candidate.whole;
            candidate.from_first = was_there_first(own);
            candidate.to_last = own.stood_to_end && stretch_of(own).last.seconds - own.end.at.seconds < options_.stay;
            in_stretch_[own.stretch].push_back(k);
        }
    }

    /// Whether something stood at the same place in another stretch.
    /// \param from_first from the stretch's beginning, and to its end in any case
    bool stood_in(std::size_t stretch, const Tracklet& own, bool from_first) const {
        return std::ranges::any_of(in_stretch_[stretch], [&](std::size_t k) {
            const Candidate& other = candidates_[k];
            return other.to_last && (!from_first || other.from_first) && is_at_same_place(other.whole, own);
        });
    }

    static bool is_at_same_place(const Tracklet& a, const Tracklet& b) {
        if (!a.settled || !b.settled) return false;
        const double off = glm::distance(a.settled->patch.centre, b.settled->patch.centre);
        return off < same_place * std::max(4.0, b.length);
    }

    /// Whether it was there from the first to the last frame, as far as there are any.
    bool was_always_there(const Candidate& candidate) const {
        if (!candidate.from_first || !candidate.to_last) return false;
        for (std::size_t k = 0; k < span_.stretches.size(); ++k) {
            const Stretch& stretch = span_.stretches[k];
            const bool can_settle = stretch.last.seconds - stretch.first.seconds >= 2 * options_.stay;
            if (k != candidate.whole.stretch && can_settle && !stood_in(k, candidate.whole, true)) return false;
        }
        return true;
    }

    Evidence evidence_of(const Candidate& candidate) const {
        const Tracklet& own = candidate.whole;
        if (scene_.empty()) return Evidence::there;
        const Settled& settled = *own.settled;
        const double empty = edge_strength(settled.patch, span_.field, [&](int i, int j) -> int {
            if (scene_.colour.empty()) return scene_.grey.at(i, j);
            const Bgr& c = scene_.colour.at(i, j);
            return (c[0] + 2 * c[1] + c[2]) / 4;
        });
        // Of a camera that shakes the empty scene is not sharp everywhere.
        if (options_.scene_is_learnt && was_always_there(candidate)) return Evidence::light;
        if (settled.edges > ghost_ratio * empty && settled.edges >= least_edges) return Evidence::there;
        if (empty > ghost_ratio * settled.edges && empty >= least_edges) return Evidence::gone;
        return settled.edges >= 2 * least_edges ? Evidence::there : Evidence::light;
    }

    void judge(Candidate& candidate) {
        const Tracklet& own = candidate.whole;
        const double needed = options_.own_lengths * own.length *
                              (1 + options_.flicker_lengths * std::min(3.0, own.flicker / options_.flicker));
        const bool went = own.moved >= needed && own.seen >= options_.seen_part;
        const bool stands_only = own.settled && own.stood_from_start;
        const bool jumps =
            own.continuous < options_.continuous || (!own.settled && straightness_of(own.path) < options_.steady_way);
        const bool inside = !own.begin.at_border && !own.end.at_border && !own.settled;
        const double least = !inside ? options_.least : own.from ? options_.least_fragment : options_.least_inside;
        candidate.wanted = own.seconds() >= least && !jumps && (went || own.settled);
        if (!candidate.wanted) return;
        if (!stands_only) {
            candidate.kind = own.stays.empty() ? EventKind::moved : EventKind::stood;
            return;
        }
        switch (evidence_of(candidate)) {
            case Evidence::there:
                candidate.kind = EventKind::left;
                break;
            case Evidence::gone:
                judge_ghost(candidate);
                break;
            case Evidence::light:
                candidate.wanted = false;
                break;
        }
    }

    /// A ghost is where something of the empty scene is not.
    void judge_ghost(Candidate& candidate) {
        Tracklet& own = candidate.whole;
        candidate.kind = EventKind::taken;
        const bool was_never_there =
            candidate.from_first && (own.stretch == 0 || stood_in(own.stretch - 1, own, false));
        if (!was_never_there) {
            own.stays.clear();
            return;
        }
        // The empty scene was made of later frames: it came when the ghost went.
        candidate.kind = EventKind::left;
        own.in_scene = true;
        own.begin.at = own.gone;
        own.end.at = stretch_of(own).last;
        if (own.seconds() < options_.stay) candidate.wanted = false;
        own.from = own.into;
        own.into.reset();
        own.path = {{own.begin.at, own.settled->patch.centre}, {own.end.at, own.settled->patch.centre}};
        own.box = own.settled->patch.box;
        own.stays = {{own.begin.at, own.end.at, own.settled->patch.centre, own.box}};
        own.portrait.reset();
    }

    /// Where an object was at a moment; nothing where it was not seen then.
    static std::optional<PixelBox> box_at(const Tracklet& object, double seconds, std::int64_t frame) {
        for (const Stay& stay : object.stays) {
            if (seconds >= stay.first.seconds && seconds <= stay.last.seconds) return stay.box;
        }
        if (frame < object.begin.at.frame || frame > object.end.at.frame || object.path.empty()) return std::nullopt;
        const glm::ivec2 place(glm::round(place_at(object.path, frame)));
        const glm::ivec2 half(glm::ceil(0.5 * object.size));
        return PixelBox{place.x - half.x, place.y - half.y, place.x + half.x, place.y + half.y};
    }

    /// Whether one is a part of another: that is about it for most of its time.
    static bool is_fragment_of(const Tracklet& piece, const Tracklet& whole) {
        constexpr int samples = 12;
        int inside = 0;
        for (int n = 0; n < samples; ++n) {
            const double part = (n + 0.5) / samples;
            const double seconds = piece.begin.at.seconds + part * piece.seconds();
            const auto frames = static_cast<double>(piece.end.at.frame - piece.begin.at.frame);
            const std::int64_t frame = piece.begin.at.frame + std::llround(part * frames);
            const std::optional<PixelBox> own = box_at(piece, seconds, frame);
            const std::optional<PixelBox> other = box_at(whole, seconds, frame);
            if (!own || !other) continue;
            const PixelBox near = other->inflated(1 + other->width() / 8, 1 + other->height() / 8);
            const PixelBox both = intersection(near, *own);
            if (both.empty()) continue;
            const double all = std::max(1.0, static_cast<double>(own->width()) * own->height());
            if (both.width() * both.height() >= piece_inside * all) ++inside;
        }
        return inside >= piece_shared * samples;
    }

    void absorb_fragments() {
        std::vector<std::size_t> order(candidates_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto size_of = [&](std::size_t k) {
            const Tracklet& own = candidates_[k].whole;
            return own.settled ? std::max<double>(own.area, own.settled->patch.area) : own.area;
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
                const bool small = 2 * size_of(order[b]) <= size_of(order[a]);
                if (!piece.wanted || (!small && !piece.whole.stood_from_start)) continue;
                if (is_fragment_of(piece.whole, whole.whole)) piece.wanted = false;
            }
        }
    }

    /// Whether somebody was beside the place of a thing at a moment of the seconds before it came, or went.
    bool was_beside(const Tracklet& bearer, const Tracklet& thing) const {
        constexpr int samples = 8;
        const PixelBox& place = thing.settled->patch.box;
        for (int n = 0; n <= samples; ++n) {
            const double seconds = thing.begin.at.seconds + just_after - n * (just_after + just_before) / samples;
            const double frames = (seconds - thing.begin.at.seconds) / span_.seconds_per_frame();
            const std::optional<PixelBox> box = box_at(bearer, seconds, thing.begin.at.frame + std::llround(frames));
            if (box && box->inflated(1 + box->width(), 1 + box->height() / 2).intersects(place)) return true;
        }
        return false;
    }

    /// Whether it was there when the clip began; or when a stretch after a gap did, if it had been an event before the
    /// gap. What is new after a gap may be another light, or a camera that was turned.
    bool was_there_before(const Tracklet& own) const {
        if (!was_there_first(own)) return false;
        return own.stretch == 0 || std::ranges::any_of(in_stretch_[own.stretch - 1], [&](std::size_t k) {
                   return candidates_[k].wanted && candidates_[k].to_last &&
                          is_at_same_place(candidates_[k].whole, own);
               });
    }

    /// Nothing is put down by nobody: what appears in the middle of a scene with nobody beside it is a patch of light,
    /// a caption, or what a codec leaves.
    void find_carrier(std::size_t k) {
        Candidate& candidate = candidates_[k];
        Tracklet& own = candidate.whole;
        if (!candidate.wanted || !row_of(candidate.kind).is_thing || !own.settled) return;
        if (own.from && object_of_.contains(*own.from)) return;
        if (was_there_first(own) && !was_there_before(own)) {
            candidate.wanted = false;
            return;
        }
        // Of few frames per second somebody may come and go between two.
        if (was_there_first(own) || span_.seconds_per_frame() > most_between) return;
        bool any = false;
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t other = 0; other < candidates_.size(); ++other) {
            const Tracklet& bearer = candidates_[other].whole;
            if (other == k || bearer.stood_from_start || !was_beside(bearer, own)) continue;
            any = true;
            const double away = glm::distance(place_at(bearer.path, own.begin.at.frame), own.settled->patch.centre);
            if (!candidates_[other].wanted || away >= nearest) continue;
            nearest = away;
            own.from = bearer.number;
        }
        if (!any) candidate.wanted = false;
    }

    /// Whether a thing went as it came, with its bearer never a length away from it: a part of who stood there.
    bool was_never_alone(std::size_t k) const {
        const Candidate& candidate = candidates_[k];
        const Tracklet& own = candidate.whole;
        if (!candidate.wanted || candidate.kind != EventKind::left || !own.from || !own.into) return false;
        const auto from = object_of_.find(*own.from);
        const auto into = object_of_.find(*own.into);
        if (from == object_of_.end() || into == object_of_.end() || from->second != into->second) return false;
        const Tracklet& bearer = candidates_[from->second].whole;
        return std::ranges::none_of(bearer.path, [&](const PathPoint& point) {
            return point.at.frame >= own.begin.at.frame && point.at.frame <= own.end.at.frame &&
                   glm::distance(point.place, own.settled->patch.centre) >= bearer.length;
        });
    }

    /// When whoever left a thing was a length away from it for the last time before the thing went, or had gone.
    static std::optional<Moment> alone_since(const Event& thing, const Event& owner, double length) {
        if (owner.last.seconds < thing.first.seconds) return thing.first;
        std::optional<Moment> since;
        const glm::dvec2 place = thing.path.front().place;
        for (const PathPoint& point : owner.path) {
            if (point.at.seconds < thing.first.seconds || point.at.seconds > thing.last.seconds) continue;
            const bool near = glm::distance(point.place, place) < length;
            if (near) since.reset();
            if (!near && !since) since = point.at;
        }
        if (!since && owner.last.seconds < thing.last.seconds) since = owner.last;
        return since;
    }

    std::vector<Event> listed() {
        std::vector<std::size_t> order;
        for (std::size_t k = 0; k < candidates_.size(); ++k) {
            if (candidates_[k].wanted) order.push_back(k);
        }
        std::ranges::stable_sort(order, {}, [&](std::size_t k) {
            const Tracklet& own = candidates_[k].whole;
            return std::pair(own.begin.at.frame, own.number);
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
            Tracklet& own = candidate.whole;
            Event event;
            event.kind = candidate.kind;
            event.first = own.begin.at;
            event.last = own.end.at;
            event.box = intersection(own.box, {0, 0, span_.field.width, span_.field.height});
            event.path = thinned(std::move(own.path));
            event.path_length = length_of(event.path);
            event.stays = std::move(own.stays);
            event.from = place_of(own.from, k);
            event.into = place_of(own.into, k);
            if (row_of(event.kind).is_thing) event.by = event.from;
            event.portrait = own.portrait;
            if (own.in_scene && own.settled) {
                event.in_scene = ScenePatch{own.settled->patch.box, own.settled->patch.values};
            }
            for (const std::size_t part : candidate.parts) event.tracks.push_back(tracklets_[part].number);
            events.push_back(std::move(event));
        }
        for (std::size_t p = 0; p < events.size(); ++p) {
            Event& event = events[p];
            if (event.kind != EventKind::left || !event.by) continue;
            event.alone_since = alone_since(event, events[*event.by], candidates_[order[*event.by]].whole.length);
        }
        return events;
    }

    static constexpr double piece_inside = 0.6;  // of a piece's box that lies in that of the whole
    static constexpr double piece_shared = 0.7;  // of its time
    static constexpr double same_place = 0.5;    // of a thing's length, by which it is off where it was before a gap
    static constexpr double least_group = 1.4;   // times a group is larger than one of it
    static constexpr double most_group = 3.3;
    static constexpr double small_part = 0.7;    // of a group's area: then it was not the group yet
    static constexpr double just_before = 3;     // seconds before a thing comes to light in which its bearer was there
    static constexpr double just_after = 0.5;    // and after
    static constexpr double most_between = 0.5;  // seconds from frame to frame
    static constexpr double ghost_ratio = 1.3;   // by which the edges must be stronger on one side
    static constexpr double least_edges = 10;    // grey levels; weaker ones are those of light and noise

    std::vector<Tracklet> tracklets_;
    Span span_;
    const fields::Planes& scene_;
    EventOptions options_;
    std::vector<Candidate> candidates_;
    std::vector<std::vector<std::size_t>> in_stretch_;  // places of the candidates in each
    std::map<std::size_t, std::size_t> object_of_;      // from the number of a track to its object
};

}  // namespace

std::vector<Event> conclude(std::vector<Tracklet> tracklets, const Span& span, const fields::Planes& scene,
                            const EventOptions& options) {
    return Conclusion(std::move(tracklets), span, scene, options).run();
}

}  // namespace vvr::events
