#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "cli/observe/observe.h"

namespace vvr::app {

/// Called once for each event when it has ended for good, with the number that pictures and pages show.
using EndedSink = std::function<void(const tracking::Event& event, std::size_t number)>;

/// The observation of a window that slides over a clip: frames are added, and old bricks are removed.
class Window {
  public:
    /// Called when a brick is full, with the window's observation.
    using FullSink = std::function<void(const Observation& seen, std::int64_t brick)>;

    /// \param ended called when an event has ended for good; may be empty
    Window(const ObservePlan& plan, const fields::FieldSource& source, FullSink full, EndedSink ended = {});
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// What the window needs from the fields.
    const fields::FieldNeeds& needs() const { return needs_; }

    void add(const media::SharedFrame& frame, const fields::Field& field);

    /// Call it after the last frame; the last brick may be short. Frames, times and events are those of the clip; the
    /// rest is that of the last window.
    Observation finish(const fields::FieldSource& source, fields::FieldSummary summary);

  private:
    enum class Draw { no, yes };

    void keep_key_frame(const media::SharedFrame& frame);
    void drop_oldest();
    void fill_gap(const fields::Field& next);
    void add_missing(std::int64_t index, double pts, Draw wanted);
    void complete_newest(Draw wanted);
    void look_at_events();
    void forget_crops_before(double seconds);
    void name_events(const std::vector<tracking::Event>& events);
    std::size_t first_track_of(const tracking::Event& event) const { return first_tracks_.at(event.tracks.front()); }
    std::size_t number_of(const tracking::Event& event);
    void number_as_shown(ShownEvents& shown);
    std::set<std::size_t> tracks_of_bearers(double seconds) const;
    void report_ended(const std::vector<tracking::Event>& events, bool all);

    const ObservePlan& plan_;
    fields::FieldNeeds needs_;
    ObservationBuilder builder_;
    Observation& seen_;
    FullSink full_;
    EndedSink ended_;
    std::set<std::size_t> reported_;  ///< the first tracks of the events that `ended_` has got
    std::set<std::size_t> bearers_;   ///< tracks that explain things that are still there
    double looked_ = 0;               ///< seconds; the last frame when events were last looked at
    LiveObjects objects_;
    std::map<std::size_t, std::size_t> numbers_;       ///< of the events already shown, by first track
    std::map<std::size_t, std::size_t> first_tracks_;  ///< of the last events, by track
    std::optional<Moment> begin_;                      ///< of the clip
    std::deque<media::SharedFrame> first_of_bricks_;   ///< first frames of the bricks in the window
    std::int64_t newest_ = 0;                          ///< number of the brick being filled
    std::int64_t frames_of_newest_ = 0;
};

}  // namespace vvr::app
