#include "cli/observe/window.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/tracking/event_options.h"

namespace vvr::app {

Window::Window(const ObservePlan& plan, const fields::FieldSource& source, FullSink full, EndedSink ended)
    : plan_(plan),
      needs_(needs_of(plan, source, plan.volume.window.frames())),
      builder_(plan,
               {.capacity = std::max<std::int64_t>(2, plan.volume.window.layers()),
                .step = plan.volume.window.step,
                .span = plan.volume.window.layers()},
               needs_),
      seen_(builder_.seen),
      full_(std::move(full)),
      ended_(std::move(ended)) {
    seen_.info = source.info();
    needs_.scene = builder_.scene_sink();
    needs_.find_living = builder_.living_finder();
    if (plan.volume.colours_objects()) seen_.identify = objects_.identify();
}

void Window::add(const media::SharedFrame& frame, const fields::Field& field) {
    if (begin_) fill_gap(field);
    if (!begin_) begin_ = {field.index, field.pts};
    if (seen_.volume.frames() == plan_.volume.window.frames()) drop_oldest();
    const tracking::FrameLabels& labels = builder_.add(frame, field);
    if (plan_.volume.colours_objects()) objects_.see(labels);
    if (frames_of_newest_ == 0) first_of_bricks_.push_back(frame);
    keep_key_frame(frame);
    seen_.last = frame;
    if (++frames_of_newest_ == plan_.volume.window.brick_frames()) complete_newest(Draw::yes);
}

Observation Window::finish(const fields::FieldSource& source, fields::FieldSummary summary) {
    if (frames_of_newest_ > 0) complete_newest(Draw::yes);
    if (begin_) seen_.begin = *begin_;
    seen_.events.reset();
    if (builder_.finder && (ended_ || plan_.field.lists_events)) {
        builder_.set_findings(builder_.finder->finish());
        builder_.identify();
        const std::vector<tracking::Event> events = take_chosen_events(seen_, plan_.field.events);
        name_events(events);
        if (ended_) {
            report_ended(events, true);
        } else {
            seen_.events = events_between(events, seen_.begin.seconds, seen_.last->pts);
            number_as_shown(*seen_.events);
        }
    }
    seen_.summary = std::move(summary);
    seen_.summary.problems.insert(seen_.summary.problems.end(), seen_.relearnt.begin(), seen_.relearnt.end());
    seen_.info = source.info();          // only now complete for a recording of several files
    seen_.identify = volume::no_styles;  // the other one refers to the objects of this window
    return std::move(seen_);
}

/// Stores the newest frame if it is a key frame.
void Window::keep_key_frame(const media::SharedFrame& frame) {
    const std::int64_t step = plan_.volume.window.step;
    const std::vector<std::int64_t>& layers = plan_.volume.window.key_layers;
    if (frames_of_newest_ % step != 0 || std::ranges::find(layers, frames_of_newest_ / step) == layers.end()) return;
    seen_.keyframes.push_back({frame, seen_.volume.frames() - 1});
}

void Window::drop_oldest() {
    seen_.volume.drop_front(plan_.volume.window.brick_layers);
    first_of_bricks_.pop_front();
    for (KeyFrame& key : seen_.keyframes) key.number -= plan_.volume.window.brick_frames();
    std::erase_if(seen_.keyframes, [](const KeyFrame& key) { return key.number < 0; });
    // Nobody lists those of a stream of days.
    if (!plan_.field.lists_events)
        std::erase_if(seen_.gaps, [&](const media::FrameGap& gap) { return gap.end < seen_.begin.seconds; });
    if (first_of_bricks_.empty()) return;
    for (auto* const intervals : {&seen_.missing, &seen_.damaged, &seen_.other_light})
        std::erase_if(*intervals, [&](const auto& some) { return some.end < first_of_bricks_.front()->pts; });
}

/// Fills the gap of missing frame numbers in a stream. A brick without any frame gets no picture; a brick with some is
/// drawn. Of a gap longer than the window, only the end is shown.
void Window::fill_gap(const fields::Field& next) {
    const media::Frame& last = *seen_.last;  // add_missing leaves it as it is
    const std::int64_t gap = next.index - last.index - 1;
    const double length = (next.pts - last.pts) / static_cast<double>(gap + 1);
    const std::int64_t brick = plan_.volume.window.brick_frames();
    const std::int64_t of_newest = frames_of_newest_ > 0 ? std::min(gap, brick - frames_of_newest_) : 0;
    for (std::int64_t i = 1; i <= of_newest; ++i) {
        add_missing(last.index + i, last.pts + static_cast<double>(i) * length, Draw::yes);
    }
    for (std::int64_t i = std::min(gap - of_newest, plan_.volume.window.frames()); i > 0; --i) {
        add_missing(next.index - i, next.pts - static_cast<double>(i) * length, Draw::no);
    }
}

/// \param wanted whether to draw a brick that this frame completes
void Window::add_missing(std::int64_t index, double pts, Draw wanted) {
    if (seen_.volume.frames() == plan_.volume.window.frames()) drop_oldest();
    seen_.volume.add_missing(index, pts);
    if (frames_of_newest_ == 0) {
        first_of_bricks_.push_back(std::make_shared<const media::Frame>(media::Frame{index, pts, {}, {}}));
    }
    if (++frames_of_newest_ == plan_.volume.window.brick_frames()) complete_newest(wanted);
}

void Window::complete_newest(Draw wanted) {
    seen_.first = first_of_bricks_.front();
    seen_.begin = {seen_.first->index, seen_.first->pts};
    seen_.first_brick = newest_ - std::ssize(first_of_bricks_) + 1;
    objects_.decide(seen_.begin.frame);
    if (wanted == Draw::yes) {
        if (builder_.finder) look_at_events();
        full_(seen_, newest_);
    }
    ++newest_;
    frames_of_newest_ = 0;
}

/// Remembers the first track of each event, by which it is known from look to look. If that track has been forgotten,
/// the rest of the event is still known by it.
void Window::name_events(const std::vector<tracking::Event>& events) {
    std::set<std::size_t> present;
    for (const tracking::Event& event : events) present.insert(event.tracks.begin(), event.tracks.end());
    std::map<std::size_t, std::size_t> first_tracks;
    for (const tracking::Event& event : events) {
        const auto before = first_tracks_.find(event.tracks.front());
        const bool is_forgotten = before != first_tracks_.end() && !present.contains(before->second);
        const std::size_t first = is_forgotten ? before->second : event.tracks.front();
        for (const std::size_t track : event.tracks) first_tracks[track] = first;
    }
    first_tracks_ = std::move(first_tracks);
}

std::size_t Window::number_of(const tracking::Event& event) {
    return numbers_.try_emplace(first_track_of(event), numbers_.size() + 1).first->second;
}

/// Once shown, an object keeps its number in all pictures, and in the report.
void Window::number_as_shown(ShownEvents& shown) {
    std::ranges::transform(shown.events, shown.numbers.begin(),
                           [&](const tracking::Event& event) { return number_of(event); });
}

/// Passes on the events that have ended for good: none of their tracks is followed, and no later one can be linked.
/// \param all also those that the end of the stream has cut
void Window::report_ended(const std::vector<tracking::Event>& events, bool all) {
    std::set<std::size_t> reported;
    for (const tracking::Event& event : events) {
        const double ago = seen_.last->pts - event.last.seconds;
        // Of a group, the same person may come out again.
        const double wait = event.into ? tracking::thresholds.memory : tracking::thresholds.link.seconds;
        const bool is_over = all || (ago > wait && !builder_.finder->follows(event.tracks));
        const std::size_t first = first_track_of(event);
        const bool before = reported_.contains(first);
        if (is_over && !before) ended_(event, number_of(event));
        if (is_over || before) reported.insert(first);
    }
    reported_ = std::move(reported);  // the others have been forgotten
}

/// Removes the pictures of objects that were forgotten. In a stream of days, there would be no room for new ones.
void Window::forget_crops_before(double seconds) {
    std::set<std::size_t> found;
    for (const tracking::Event& event : seen_.findings.events) found.insert(event.tracks.begin(), event.tracks.end());
    seen_.crops.forget_before(seconds, [&](std::size_t track) {
        return !found.contains(track) && !builder_.finder->follows(std::span(&track, 1));
    });
}

/// The tracks of those who brought or took the things that are still there. Without them, nobody would have left a
/// thing.
std::set<std::size_t> Window::tracks_of_bearers(double seconds) const {
    std::set<std::size_t> tracks;
    const std::vector<tracking::Event>& events = seen_.findings.events;
    for (const tracking::Event& event : events) {
        const bool lasts = event.last.seconds >= seconds || builder_.finder->follows(event.tracks);
        if (!event.evidence || !lasts) continue;
        for (const std::optional<std::size_t>& other : {event.from, event.into, event.by}) {
            if (other) tracks.insert(events[*other].tracks.begin(), events[*other].tracks.end());
        }
    }
    return tracks;
}

/// Updates the events in the window as if the clip ended here.
void Window::look_at_events() {
    constexpr double remembered = tracking::thresholds.memory;  // whoever returns within it may be the same object
    // After a gap in the signal, the last look may be long ago: what ended since then isn't reported yet.
    const double kept = ended_ ? std::min(seen_.begin.seconds, looked_) : seen_.begin.seconds;
    if (!plan_.field.lists_events) builder_.finder->forget_ended_before(kept - remembered, bearers_);
    looked_ = seen_.last->pts;
    tracking::EventFinder until_now = *builder_.finder;
    builder_.set_findings(until_now.finish());
    seen_.findings.largest_share = builder_.finder->largest_share_since(seen_.begin.seconds);
    bearers_ = tracks_of_bearers(kept - remembered);
    if (!plan_.field.lists_events) forget_crops_before(kept - remembered);
    builder_.identify();
    const std::vector<tracking::Event> events = take_chosen_events(seen_, plan_.field.events);
    name_events(events);
    ShownEvents shown = events_between(events, seen_.begin.seconds, seen_.last->pts);
    number_as_shown(shown);
    for (std::size_t k = 0; k < shown.events.size(); ++k) {
        const std::vector<std::size_t>& tracks = shown.events[k].tracks;
        // The colour is that of its voxels.
        for (const std::size_t track : tracks) {
            shown.colours[k] = objects_.colour_of(track).value_or(shown.colours[k]);
            objects_.give_number(track, shown.numbers[k]);
        }
    }
    if (ended_) report_ended(events, false);
    seen_.events = std::move(shown);
    seen_.scene = media::picture_of(*seen_.first);
}

}  // namespace vvr::app
