#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/events/event.h"
#include "core/events/track.h"

namespace vvr {

/// Finds the events of a clip in its fields, one after the other; memory depends on what is to be seen at a time, and
/// on the number of events.
///
/// Objects of consecutive fields that overlap are one event. Those that meet stay two: each is looked for within what
/// they are together, by what it was before. An object that comes apart gives a new event; a part that stands still
/// began when it became still, which is when a bag was put down and not when whoever brought it had gone.
class EventFinder {
  public:
    EventFinder(Size field, const EventOptions& options = {});

    /// \param field 0 = nothing; else part of an object
    /// \param now later than in the call before
    void add(const Plane<std::uint8_t>& field, const Moment& now);

    /// The events, by their first times. To be called once, after the last field.
    std::vector<Event> finish();

  private:
    struct Followed {
        Track track;
        std::optional<std::size_t> from;
        std::optional<std::size_t> near;  ///< who is in front of it, or about it
        bool over = false;
    };
    struct Ended {
        Event event;
        std::size_t number;
        std::optional<std::size_t> from;
        std::optional<std::size_t> into;
    };
    using Choices = std::vector<std::vector<std::size_t>>;  ///< tracks that go on in each blob

    Plane<std::uint8_t> without_standing(const Plane<std::uint8_t>& field, const Moment& now);
    Choices choose(const Blobs& blobs);
    void share_out(const Blobs& blobs, Choices& choices) const;
    void look_after_hidden(const Plane<std::uint8_t>& field, const Blobs& blobs, Choices& choices, const Moment& now);
    bool rises(std::size_t k, const Blobs& blobs, Choices& choices);
    std::optional<std::size_t> about(const Track& standing) const;
    void join_pieces(std::vector<std::size_t>& chosen);
    void go_on(const Plane<std::uint8_t>& field, const Blobs& blobs, const Choices& choices, const Moment& now);
    void begin(const Patch& patch, std::optional<std::size_t> from, const Moment& now);
    void settle(const Moment& now);
    void join_standing(Followed& part);
    void end(Followed& followed, bool taken);
    std::vector<int> overlaps(const Track& track, const Blobs& blobs, const glm::ivec2& by) const;

    EventOptions options_;
    Size field_;
    int reach_;
    int min_area_;
    std::size_t next_ = 0;
    Steadiness steadiness_;
    std::vector<Followed> followed_;
    std::vector<std::vector<int>> overlap_;  ///< of each that is followed with each blob
    std::vector<Ended> ended_;
};

}  // namespace vvr
