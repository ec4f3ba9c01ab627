#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "cli/observe/observe.h"
#include "cli/plan/observer.h"
#include "cli/plan/plan.h"
#include "cli/plan/settings.h"
#include "core/condition/condition.h"
#include "core/fields/field_source.h"
#include "core/media/live_source.h"
#include "core/page/moments.h"
#include "core/tracking/event_line.h"

namespace vvr::app {

/// How long to watch a stream, and how long to wait for it.
struct StreamOptions {
    std::optional<double> duration{};                 ///< seconds; none = unlimited
    double patience = media::LiveOptions{}.patience;  ///< as in LiveOptions
    std::string camera{};                             ///< for events; empty = from the title or the file's name
    /// Called with each event and each interval that has ended, on the thread that calls run(); may be empty.
    std::function<void(const tracking::EventLine&)> on_event{};
};

/// Watches a stream and draws its picture again after each brick.
class StreamWatch {
  public:
    /// Connects to the stream.
    /// \throws Error usage, not_video, io
    StreamWatch(const RenderJob& job, const StreamOptions& options, Observer& observer);

    /// Draws until the stream ends or is stopped.
    /// \returns the number of pictures
    /// \throws Error of every kind
    std::int64_t run();

    /// Ends the stream soon; the last brick is still drawn. May be called from any thread.
    void stop() { stream_->stop(); }

    const std::string& name() const { return stream_->info().name; }

  private:
    tracking::EventLine line_of_time(double first, double last, std::string_view kind) const;
    tracking::EventLine line_of(const tracking::Event& event, std::size_t number) const;
    void report_intervals(const Observation& seen, double until);

    Observer& observer_;
    StreamOptions options_;
    std::unique_ptr<const Plan> plan_;
    std::unique_ptr<fields::FieldSource> fields_;
    media::LiveSource* stream_;                                        ///< owned by fields_
    std::array<double, condition::condition_rows.size()> reported_{};  ///< end of the last interval of each kind, s
};

}  // namespace vvr::app
