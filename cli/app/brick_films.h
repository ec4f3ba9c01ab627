#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/plan/observer.h"
#include "cli/plan/plan.h"
#include "core/media/frame_source.h"
#include "core/page/page.h"
#include "core/page/preview.h"

namespace vvr::app {

/// A film of what a stream's page shows: a small video of each brick, beside the page. They take turns with as many
/// files as the window has bricks, and two more for whoever still has an older page. So no other file is touched, and a
/// later run uses the same ones.
class BrickFilms {
  public:
    /// \throws Error output_replaces_input
    BrickFilms(const Plan& plan, const media::VideoInfo& info, Observer& observer);

    void add(const media::SharedFrame& frame);

    /// Writes the film of a brick.
    void end_brick();

    /// The films that show something of the stream after a moment.
    std::vector<page::PageContent::Segment> since(double seconds) const;

  private:
    std::int64_t places() const { return window_.bricks + 2; }
    std::filesystem::path file_at(std::int64_t place, const std::string& extension) const;

    std::filesystem::path page_;  ///< empty = there is none
    SlidingWindow window_;
    media::VideoInfo info_;
    Observer& observer_;
    std::optional<page::PreviewThread> video_;  ///< of the brick that comes
    double begin_ = 0;                          ///< of it, seconds
    double end_ = 0;
    std::deque<page::PageContent::Segment> films_;
    std::int64_t next_ = 0;
    bool has_failed_ = false;
};

}  // namespace vvr::app
