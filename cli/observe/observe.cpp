#include "cli/observe/observe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "core/annotation/time_ticks.h"
#include "core/base/error.h"
#include "core/condition/thresholds.h"
#include "core/fields/settings.h"
#include "core/scene/theme.h"

namespace vvr::app {

namespace {

volume::VolumeOptions with_contents(volume::VolumeOptions room, const ObservePlan& plan,
                                    const fields::FieldNeeds& needs) {
    room.seed_interval = needs.every;
    room.values = plan.field.filter->traits.values;
    room.keep_flow = needs.flow;
    room.keep_owners = plan.volume.colours_objects();
    room.nonuniform = plan.volume.nonuniform;
    room.marked_late = plan.field.finds_objects;
    return room;
}

/// Moves a ghost in the fields to the right time. The reference contained the object until it left, so the fields show
/// a ghost afterwards.
void correct_ghosts(std::span<const tracking::Event> events, volume::Volume& volume) {
    for (const tracking::Event& event : events) {
        if (!event.in_scene || event.tracks.empty()) continue;
        for (const std::size_t track : event.tracks) volume.remove_track(track);
        volume.insert_track(event.tracks.front(), event.in_scene->box, event.in_scene->values, event.first.seconds,
                            event.last.seconds);
    }
}

/// Takes stills from the empty scene for objects that it contains: those left for most of the clip, and those taken
/// away.
void take_stills_from_scene(Observation& seen) {
    const auto frame_of = [](const Plane<Bgr>& scene) {
        return media::Frame{0, 0, Plane<std::uint8_t>(scene.size()), scene};
    };
    const media::Frame usual = frame_of(seen.scene);
    std::vector<media::Frame> others;
    for (const fields::Reference& other : seen.summary.reference.others) others.push_back(frame_of(other.colour));
    for (const tracking::Event& event : seen.findings.events) {
        const bool in_scene = event.in_scene.has_value() || row_of(event.kind).is_of_scene;
        if (!in_scene || event.tracks.empty()) continue;
        seen.crops.keep(event.tracks.front(), {event.first, event.box, annotation::score_of_scene},
                        event.view == 0 ? usual : others.at(event.view - 1));
    }
}

/// The empty scene, or if there is none, the last frame.
Plane<Bgr> scene_of(const Observation& seen) {
    const fields::Planes& scene = seen.summary.reference.planes();
    return media::picture_of(scene.empty() ? *seen.last : media::Frame{0, 0, scene.grey, scene.colour});
}

/// Reads the frames of events again whose stills had to make room: a day has more tracks of twigs and insects than
/// there is room for, and they may look better than a person in the dark.
void take_stills_again(Observation& seen, fields::FieldSource& source) {
    std::map<double, std::vector<const tracking::Event*>> missing;
    std::set<std::size_t> tracks;
    for (const tracking::Event& event : seen.findings.events) {
        tracks.insert(event.tracks.begin(), event.tracks.end());
        const bool lacks = event.portrait && !event.tracks.empty() && seen.crops.find(event) == nullptr;
        if (lacks) missing[event.portrait->at.seconds].push_back(&event);
    }
    if (missing.empty()) return;
    seen.crops.forget_before(std::numeric_limits<double>::infinity(),
                             [&](std::size_t track) { return !tracks.contains(track); });
    std::vector<double> times;
    for (const auto& [seconds, events] : missing) times.push_back(seconds);
    source.read_again(times, [&](const media::Frame& frame) {
        for (const tracking::Event* event : missing.at(frame.pts))
            seen.crops.keep(event->tracks.front(), *event->portrait, frame);
    });
}

/// The moment from `begin` to `end` at which objects cover least of a place, and of those the nearest to `near`.
/// \param but a thing's own tracks, which don't cover it
const annotation::Still* clearest(std::span<const annotation::Still> stills, const PixelBox& place, double begin,
                                  double end, double near, std::span<const std::size_t> but) {
    const annotation::Still* clearest = nullptr;
    std::pair<int, double> least;
    for (const annotation::Still& still : stills) {
        if (still.seconds < begin || still.seconds > end) continue;
        int covered = 0;
        for (const annotation::ObjectInStill& object : still.objects) {
            if (std::ranges::find(but, object.track) != but.end()) continue;
            const PixelBox part = intersection(object.box, place);
            if (!part.empty()) covered += part.width() * part.height();
        }
        const std::pair<int, double> cost(covered, std::abs(still.seconds - near));
        if (clearest != nullptr && cost >= least) continue;
        clearest = &still;
        least = cost;
    }
    return clearest;
}

/// Reads frames again that show the places of things that were left or taken, and those that were changed: before, and
/// after.
void take_pairs(Observation& seen, fields::FieldSource& source) {
    constexpr std::size_t most = 8;     // reading a frame again takes as long as several
    constexpr double beside = 0.5;      // seconds: while it is put down or taken, somebody covers it
    constexpr double long_before = 60;  // seconds, after which the light may be another
    struct Wanted {
        const tracking::Event* event;
        PixelBox place;
        std::array<const annotation::Still*, 2> moments;
        std::array<std::optional<annotation::Crop>, 2> crops{};
    };
    std::vector<Wanted> wanted;
    std::set<double> times;
    for (const tracking::Event& event : seen.findings.events) {
        if (wanted.size() == most) break;
        if (!row_of(event.kind).is_thing || event.tracks.empty()) continue;
        const tracking::Stay* const stay = annotation::longest_stay(event);
        const PixelBox place = stay != nullptr ? stay->box : event.box;
        const PixelBox around = place.inflated(place.width() / 2, place.height() / 2);
        const double came = event.first.seconds;
        const std::array moments{clearest(seen.stills, around, came - long_before, came - beside, came, {}),
                                 clearest(seen.stills, around, came + beside, event.last.seconds, came, event.tracks)};
        if (moments[0] == nullptr || moments[1] == nullptr) continue;
        wanted.push_back({&event, place, moments});
        times.insert({moments[0]->seconds, moments[1]->seconds});
    }
    if (wanted.empty()) return;
    source.read_again(std::vector(times.begin(), times.end()), [&](const media::Frame& frame) {
        for (Wanted& one : wanted) {
            for (std::size_t k = 0; k < one.moments.size(); ++k) {
                const Moment at{one.moments[k]->frame, one.moments[k]->seconds};
                if (at.seconds == frame.pts) one.crops[k].emplace(tracking::Portrait{at, one.place, 0}, frame);
            }
        }
    });
    for (auto& [event, place, moments, crops] : wanted) {
        if (crops[0] && crops[1]) seen.crops.keep_pair(*event, {std::move(*crops[0]), std::move(*crops[1])});
    }
}

/// Fills a gap in the recording, where frame numbers are missing.
void fill_gap(const media::Frame& last, const fields::Field& next, volume::Volume& volume) {
    if (volume.frames() == 0 || next.index <= last.index + 1) return;
    const std::int64_t gap = next.index - last.index - 1;
    const double apart = (next.pts - last.pts) / static_cast<double>(gap + 1);
    volume.add_gap(last.index + 1, gap, last.pts + apart, apart);
}

}  // namespace

std::vector<tracking::Event> take_chosen_events(Observation& seen, const tracking::EventChoice& choice) {
    seen.not_chosen.clear();
    for (const tracking::Event& event : seen.findings.events) {
        const bool is_shown = event.last.seconds >= seen.begin.seconds && event.first.seconds <= seen.last->pts;
        if (is_shown && !choice.accepts(event)) seen.not_chosen.push_back({event.first.seconds, event.last.seconds});
    }
    return tracking::choose_events(std::move(seen.findings.events), choice);
}

void require_frames(std::int64_t frames, const media::VideoInfo& info) {
    if (frames > 0) return;
    throw Error(
        ErrorCode::no_frame,
        fmt::format("no frame of '{}' can be read any more; check whether it was changed or removed during the run",
                    info.name));
}

namespace {

/// After the last frame: links the tracks of each object and computes its events.
void conclude(const ObservePlan& plan, fields::FieldSource& source, ObservationBuilder& builder) {
    Observation& seen = builder.seen;
    builder.set_findings(builder.finder->finish());
    seen.volume.forget_motion();
    for (const auto& [first, last] : tracking::busy_times(seen.findings.events)) seen.volume.mark_motion(first, last);
    seen.volume.settle();
    take_stills_again(seen, source);
    take_stills_from_scene(seen);
    builder.identify();
    builder.take_stills();
    if (plan.field.keeps_portraits) take_pairs(seen, source);
    const std::vector<tracking::Event> events = take_chosen_events(seen, plan.field.events);
    if (seen.volume.keeps_owners()) {
        correct_ghosts(events, seen.volume);
        seen.identify = objects_of(events, seen.volume);
    }
    seen.events = events_between(events, seen.begin.seconds, seen.last->pts);
}

Observation read(const ObservePlan& plan, fields::FieldSource& source, std::int64_t step, Observer& observer,
                 const FrameWatch& watch) {
    const std::int64_t expected = plan.read.clip.expected_frames;
    const std::int64_t capacity = plan.volume.bricks.max_layers;
    fields::FieldNeeds needs = needs_of(plan, source, expected > 0 ? expected : step * capacity);
    ObservationBuilder builder(plan, {.capacity = capacity, .step = step}, needs);
    needs.scene = builder.scene_sink();
    needs.find_living = builder.living_finder();
    Observation& seen = builder.seen;
    const int keyframes = plan.volume.keyframes;
    int passed = 0;  // key frames, at equal distances
    if (watch.begin) watch.begin(source);
    seen.summary = source.read(needs, [&](const media::SharedFrame& frame, const fields::Field& field) {
        if (watch.add) watch.add(frame, field);
        fill_gap(*seen.last, field, seen.volume);
        builder.add(frame, field);
        const std::int64_t number = seen.volume.frames() - 1;
        if (number == 0) {
            seen.first = frame;
            seen.begin = {frame->index, frame->pts};
        }
        seen.last = frame;
        // Frames may be missing where a key frame should be. Then the next one shows the end of the gap.
        const int before = passed;
        while (expected > 0 && passed < keyframes && number >= (passed + 1) * (expected - 1) / (keyframes + 1))
            ++passed;
        if (passed > before) seen.keyframes.push_back({frame, number});
        observer.frames(number + 1, expected);
    });
    seen.summary.problems.insert(seen.summary.problems.end(), seen.relearnt.begin(), seen.relearnt.end());
    require_frames(seen.volume.frames(), source.info());
    seen.info = source.info();
    seen.scene = scene_of(seen);
    if (builder.finder) {
        conclude(plan, source, builder);
    } else {
        seen.volume.settle();
    }
    return std::move(builder.seen);
}

// Pixels per frame: no motion up to the first, motion from the second on.
constexpr float resting = 0.2F;
constexpr float moving = 0.6F;

}  // namespace

VoxelColours::VoxelColours(const ObservePlan& plan) : plan_(plan) {
    if (plan.volume.colour->filter == nullptr) return;
    for (std::size_t value = 0; value < of_value_.size(); ++value) {
        of_value_[value] = scene::bgr_of(glm::vec3(plan.volume.second_transfer.at(static_cast<double>(value))));
    }
}

Bgr VoxelColours::colour_of_flow(float u, float v) const {
    const scene::Theme& theme = plan_.volume.theme;
    const float speed = std::hypot(u, v);
    if (plan_.volume.colour->of_direction) {
        const float share = std::clamp((speed - resting) / (moving - resting), 0.F, 1.F);
        if (share == 0) return scene::bgr_of(theme.unowned);
        return scene::bgr_of(glm::mix(theme.unowned, scene::direction_colour({u, v}), share));
    }
    const glm::vec2 range = plan_.volume.speed_range;
    return scene::bgr_of(
        glm::mix(theme.slow, theme.fast, std::clamp((speed - range.x) / (range.y - range.x), 0.F, 1.F)));
}

const Plane<Bgr>& VoxelColours::operator()(const media::Frame& frame, const fields::Field& field) {
    if (plan_.volume.colour->drawn != gl::VolumeColour::own) return painted_;
    if (plan_.volume.colour->needs_pictures) return frame.colour;
    if (painted_.size() != field.scalar.size()) painted_ = Plane<Bgr>(field.scalar.size());
    const auto into = painted_.pixels().begin();
    if (plan_.volume.colour->filter != nullptr) {
        std::ranges::transform(field.second.pixels(), into, [this](std::uint8_t value) { return of_value_[value]; });
    } else if (field.flow.u.empty()) {
        std::ranges::fill(painted_.pixels(), colour_of_flow(0, 0));
    } else {
        std::ranges::transform(field.flow.u.pixels(), field.flow.v.pixels(), into,
                               [this](float u, float v) { return colour_of_flow(u, v); });
    }
    return painted_;
}

ObservationBuilder::ObservationBuilder(const ObservePlan& plan, volume::VolumeOptions room, fields::FieldNeeds needs)
    : seen{volume::Volume(plan.read.clip.field_size, with_contents(room, plan, needs))},
      find_gap_(plan.read.clip.info.rate, plan.read.clip.info.decoded_share < 1),
      plan_(plan),
      keeps_crops_(needs.full_size),
      keeps_boxes_(plan.field.keeps_boxes),
      voxel_colours_(plan) {
    if (plan.field.finds_objects)
        finder.emplace(plan.read.clip.field_size,
                       tracking::EventOptions{.scene_is_learnt = plan.field.reference != nullptr,
                                              .labels = plan.volume.colours_objects() || keeps_boxes_});
    constexpr int longer_side = 480;     // pixels of a still, of which a picture may show a part
    constexpr std::size_t moments = 64;  // about 30 MB
    if (plan.field.keeps_stills) stills_.emplace(fit_into(plan.read.clip.info.size, longer_side), moments);
    if (plan.field.finds_objects && plan.field.detector) {
        classifier_.emplace(*plan.field.detector, plan.read.threads);
        seen.crops = annotation::Crops(most_looks);
    }
}

void ObservationBuilder::set_findings(tracking::Findings findings) {
    seen.findings = std::move(findings);
    for (const PixelBox& overlay : seen.findings.overlays) seen.volume.clear(overlay);
}

void ObservationBuilder::take_stills() {
    if (stills_) seen.stills = stills_->take();
}

void ObservationBuilder::add_still(const media::SharedFrame& frame) {
    if (!stills_) return;
    std::vector<TrackBox> boxes;
    add_boxes(labels_, boxes);
    std::vector<annotation::ObjectInStill> objects;
    std::int64_t area = 0;
    for (const TrackBox& one : boxes) {
        objects.push_back({one.track, one.box});
        area += std::int64_t{one.box.width()} * one.box.height();
    }
    stills_->add(frame, area, std::move(objects));
}

void ObservationBuilder::identify() {
    if (classifier_) seen.detector = classifier_->identify(seen.findings, seen.crops);
}

fields::SceneSink ObservationBuilder::scene_sink() {
    return [this](const fields::Reference& scene) {
        if (!finder) return;
        std::vector<fields::Planes> scenes;
        for (std::size_t view = 0; view <= scene.others.size(); ++view) scenes.push_back(scene.of_view(view).planes());
        finder->set_scenes(std::move(scenes));
    };
}

fields::LivingFinder ObservationBuilder::living_finder() {
    if (!classifier_) return {};
    return [this](const media::Frame& frame) { return classifier_->living_in(frame); };
}

const tracking::FrameLabels& ObservationBuilder::add(const media::SharedFrame& frame, const fields::Field& field) {
    std::optional<double> busy_since;
    if (field.before != condition::Kind::no_signal && seen.volume.frames() > 0)
        seen.missing.push_back(
            {std::min(seen.last->pts, field.absent_since.value_or(seen.last->pts)), field.pts, field.before});
    const double before = seen.volume.frames() > 0 ? seen.last->pts : field.pts;
    if (frame->damaged) lengthen(seen.damaged, {before, field.pts, condition::Kind::damaged});
    if (field.other_light >= condition::thresholds.other_light)
        lengthen(seen.other_light, {before, field.pts, condition::Kind::light});
    if (field.scene) {
        seen.relearnt.push_back(fmt::format(
            "most of the picture changed at {}; the empty scene was learnt anew until {}, and nothing is known of what "
            "happened meanwhile",
            annotation::format_moment(field.scene->changed, plan_.read.clock),
            annotation::format_moment(field.pts, plan_.read.clock)));
    }
    if (finder) {
        tracking::TrackedFrame tracked = finder->add({field.scalar, frame->grey, frame->colour, field.view,
                                                      frame->damaged || field.other_light > 0, field.scene.get()},
                                                     {field.index, field.pts});
        labels_ = std::move(tracked.labels);
        busy_since = tracked.busy_since;
        if (keeps_boxes_) add_boxes(labels_, seen.track_boxes);
        add_still(frame);
        for (const tracking::TrackPortrait& best : tracked.portraits) {
            if (keeps_crops_) seen.crops.keep(best.track, best.portrait, *frame);
        }
    }
    // Fields in which no objects are looked for move where they are not empty.
    const bool moves = !finder && std::ranges::any_of(field.scalar.pixels(), [](int value) { return value != 0; });
    const bool skips = seen.volume.frames() > 0 && field.index > seen.last->index + 1;
    if (const auto gap = find_gap_(field.pts, skips)) seen.gaps.push_back(*gap);
    seen.volume.add(field, voxel_colours_(*frame, field), labels_.runs, moves);
    if (busy_since) seen.volume.mark_motion(*busy_since, field.pts);
    return labels_;
}

fields::FieldNeeds needs_of(const ObservePlan& plan, const fields::FieldSource& source, std::int64_t frames) {
    constexpr std::int64_t arrow_times = 80;  // arrows along the arc; more would hide each other
    fields::FieldNeeds needs;
    needs.flow = plan.field.flow;
    needs.seeds = plan.field.seeds;
    needs.flow_of_every_frame = plan.volume.colour->needs_flow;
    // Colours help to distinguish objects, if available.
    needs.colour = plan.volume.colour->needs_pictures || (plan.field.keeps_moments && source.has_pictures()) ||
                   ((plan.field.keeps_frames || plan.volume.colours_objects() || plan.field.detector != nullptr) &&
                    source.has_pictures());
    // The header's number of frames may be far too large; limit the interval to that of the setting.
    constexpr auto most = static_cast<std::int64_t>(setting::flow_every.range.high);
    needs.full_size = plan.field.keeps_portraits || plan.field.detector != nullptr;
    needs.every = std::min(most, source.interval(std::clamp<std::int64_t>(frames / arrow_times, 1, most)));
    return needs;
}

footage::Unseen unseen_of(const ObservePlan& plan, const Observation& seen) {
    footage::Unseen unseen{.areas = plan.field.areas, .masked = plan.field.masked};
    unseen.intervals = seen.missing;
    std::ranges::copy(seen.damaged, std::back_inserter(unseen.intervals));
    for (const condition::Interval& times : seen.summary.doubtful_times) {
        const double begin = std::max(times.begin, seen.begin.seconds);
        const double end = std::min(times.end, seen.end().seconds);
        if (begin < end) unseen.intervals.push_back({begin, end, times.kind});
    }
    std::ranges::copy_if(joined(seen.other_light), std::back_inserter(unseen.intervals), [](const auto& interval) {
        const double seconds = interval.end - interval.begin;
        return seconds >= condition::thresholds.flash && seconds <= condition::thresholds.passing;
    });
    for (const media::FrameGap& gap : seen.gaps) {
        if (gap.end <= seen.begin.seconds || gap.begin >= seen.end().seconds) continue;
        const std::string reason =
            media::reason_for_gap(plan.read.span, seen.info.segments, seen.missing, gap.begin, gap.end);
        if (reason == "left out") continue;
        unseen.gaps.push_back(gap);
        constexpr double little = 1;  // seconds; less is lost in any network
        if (reason == row_of(condition::Kind::no_signal).words && gap.end - gap.begin >= little)
            unseen.intervals.push_back({gap.begin, gap.end});
    }
    unseen.intervals = joined(std::move(unseen.intervals));
    unseen.damage = seen.summary.damage;
    unseen.damaged = seen.summary.damaged;
    return unseen;
}

Observation observe(const ObservePlan& plan, fields::FieldSource& source, Observer& observer, const FrameWatch& watch) {
    const BrickOptions& bricks = plan.volume.bricks;
    const std::int64_t step = planned_step(bricks, plan.read.clip.expected_frames);
    Observation seen = read(plan, source, step, observer, watch);
    // The header promised far too many frames, so most of the window is empty. Read the clip again with its true
    // length.
    if (bricks.step == 0 && step > 1 && !plan.volume.nonuniform && seen.volume.layers() < bricks.max_layers / 2 &&
        seen.volume.frames() > 1) {
        seen = read(plan, source, planned_step(bricks, seen.volume.frames()), observer, watch);
    }
    return seen;
}

}  // namespace vvr::app
