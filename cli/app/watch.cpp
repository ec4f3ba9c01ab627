#include "cli/app/watch.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <deque>
#include <filesystem>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/app/input.h"
#include "cli/app/plan.h"
#include "cli/app/record.h"
#include "cli/app/render_series.h"
#include "cli/app/write.h"
#include "core/base/text.h"
#include "core/image/text.h"
#include "core/labels/time_ticks.h"
#include "core/page/moments.h"
#include "core/video/input.h"
#include "core/video/recorder_names.h"
#include "core/video/recording.h"

namespace vvr::app {

/// How long pictures took from the last frame that they show to the disk: of the last thousand, so that days of them
/// need no memory.
class Latency {
  public:
    void add(double seconds);

    /// 0 where there was none.
    double median() const;
    double longest() const;

  private:
    static constexpr std::size_t kept = 1000;

    std::deque<double> last_;
};

void Latency::add(double seconds) {
    last_.push_back(seconds);
    if (last_.size() > kept) last_.pop_front();
}

double Latency::median() const {
    if (last_.empty()) return 0;
    std::vector<double> sorted(last_.begin(), last_.end());
    const auto middle = sorted.begin() + std::ssize(sorted) / 2;
    std::ranges::nth_element(sorted, middle);
    return *middle;
}

double Latency::longest() const {
    return last_.empty() ? 0 : std::ranges::max(last_);
}

namespace {

namespace fs = std::filesystem;
using Clock = video::LiveSource::Clock;

/// \param begin seconds since 1970 (UTC)
StartTime starts_at(std::int64_t begin, ClockSource source) {
    constexpr double longest = 400 * 86'400.0;  // seconds, for which summer time is known
    vvr::Clock clock = local_clock(begin, longest, source);
    clock.zone.clear();  // it names all zones of these days
    return {StartTime::From::given, clock};
}

/// A file was recorded before it is read, so its time is not that of this machine.
StartTime start_time_from_name(const RenderJob& job, const std::string& file) {
    const video::Segment told = video::segment_from_name(file, video::RecorderNames(job.input.name_patterns));
    if (!told.begin) return {StartTime::From::none};
    return starts_at(*told.begin, told.begin_source);
}

/// Whether a file was written to in the last seconds.
bool grows(const fs::path& file) {
    constexpr std::chrono::seconds lately{10};
    std::error_code none;
    const auto written = fs::last_write_time(file, none);
    return !none && fs::file_time_type::clock::now() - written < lately;
}

std::unique_ptr<video::LiveSource> connect(const RenderJob& job, const StreamOptions& options, Observer& observer) {
    video::LiveOptions live;
    live.source.field_size = job.input.field_size;
    live.source.rate = job.input.rate;
    live.source.colour = wants_colour(job);
    live.lag = options.lag;
    live.patience = options.patience;
    live.duration = options.duration;
    live.tell = [&observer](const std::string& text) { observer.warn(text); };
    return std::make_unique<video::LiveSource>(only_input(job.input), std::move(live));
}

/// A stream's whole address says more than its last part.
std::string title_of_stream(const std::string& name) {
    return video::is_url(name) ? name.substr(name.find("://") + 3) : shown_name(name);
}

/// Pictures on their way to the disk, and how long they took.
class LivePictures {
  public:
    LivePictures(const RenderJob& job, const video::LiveSource& stream, const page::RecentMoments& moments,
                 Observer& observer)
        : job_(job),
          name_(job.output.path),
          stream_(stream),
          moments_(moments),
          observer_(observer),
          files_(job.output, observer) {}

    void add(const RenderReport& report, int number, image::Picture&& picture) {
        const image::Metadata record = record_of(job_, report, true);
        if (is_page(job_.output.path)) {
            files_.add_page(page_text(job_, report, std::move(picture), record,
                                      moments_.since(report.first_frame, report.last_frame), state_of(report)));
        } else {
            files_.add(number, picture, record);
        }
        ++count_;
        const auto came = stream_.arrival(report.last_frame);
        const double took = came ? std::chrono::duration<double>(Clock::now() - *came).count() : 0;
        if (came) latency_.add(took);
        observer_.info(fmt::format("'{}': brick {}, {}, {:.2f} s after its last frame", name_.at(number).string(),
                                   number, span_of(report), took));
    }

    std::int64_t count() const { return count_; }
    const Latency& latency() const { return latency_; }

  private:
    std::string span_of(const RenderReport& report) const {
        return labels::format_span(report.first_pts, report.last_pts, job_.look.start_time.clock);
    }

    page::LiveState state_of(const RenderReport& report) const {
        page::LiveState state;
        state.text = is_learning(report) ? "learning the empty scene" : "watching";
        if (const auto lost = stream_.dropped()) state.text += fmt::format(", {} dropped", counted(lost, "frame"));
        state.written = std::time(nullptr);
        state.brick_seconds = static_cast<double>(report.bricks.back().count * report.step) / report.info.rate;
        return state;
    }

    /// Whether the scene may still hold what stood there when the stream began.
    bool is_learning(const RenderReport& report) const {
        const fields::ReferenceRow* const row = job_.fields.reference.row();
        constexpr std::int64_t first_look = 2 * 25;  // frames, and then ghosts go
        return row != nullptr && row->adapts && report.last_frame < first_look + fields::RunningReference::ghost_frames;
    }

    const RenderJob& job_;
    image::NamePattern name_;
    const video::LiveSource& stream_;
    const page::RecentMoments& moments_;
    Observer& observer_;
    PictureOutput files_;
    Latency latency_;
    std::int64_t count_ = 0;
};

std::string summary_of(const video::LiveSource& stream, const RenderReport& report, const LivePictures& pictures) {
    return fmt::format(
        "'{}': {} of {} in {:.1f} s; {:.2f} s from frame to picture (median), {:.2f} s at most; {} "
        "dropped, {}, {}",
        stream.info().name, counted(pictures.count(), "picture"), counted(report.frames, "frame"), report.last_pts,
        pictures.latency().median(), pictures.latency().longest(), counted(stream.dropped(), "frame"),
        counted(stream.reconnections(), "reconnection"), counted(report.damaged, "damaged packet"));
}

}  // namespace

StreamWatch::StreamWatch(const RenderJob& job, const StreamOptions& options, Observer& observer)
    : job_(with_colour(with_transfer(with_possible_parts(with_fields_of_colour(job))))), observer_(observer) {
    validate(job);
    validate_series(job);
    image::choose_font(job.look.font);
    auto connected = connect(job, options, observer);
    stream_ = connected.get();
    const video::VideoInfo& info = stream_->info();
    std::error_code none;
    if (job_.look.title.empty()) job_.look.title = title_of_stream(info.name);
    const bool is_file = fs::is_regular_file(info.name, none);
    if (job_.look.start_time.from == StartTime::From::automatic) {
        job_.look.start_time =
            is_file ? start_time_from_name(job, info.name) : starts_at(std::time(nullptr), ClockSource::live);
    }
    if (is_file && !grows(info.name)) {
        observer.warn(
            fmt::format("'{}' is a finished file, not a stream: `vvr render` draws the whole of it", info.name));
    }
    auto fields = with_listed_seeds(std::make_unique<fields::ClipFields>(std::move(connected), job_.fields), job_,
                                    *job_.fields.filter);
    const std::int64_t window = sliding_window(job_.bricks, *fields).frames();
    fields_ = std::make_unique<page::RecentMoments>(std::move(fields), window);
}

std::int64_t StreamWatch::run() {
    Products products;
    products.series = true;
    const bool page = is_page(job_.output.path);
    products.pixel_data = page || image::holds_pixel_data(job_.output.path);
    products.portraits = page;
    check_memory(make_plan(job_, products, *fields_));
    const video::VideoInfo& info = stream_->info();
    observer_.info(
        fmt::format("'{}': {}x{}, {:.4g} frames per second", info.name, info.size.width, info.size.height, info.rate));
    LivePictures pictures(job_, *stream_, *fields_, observer_);
    const RenderReport report = render_series(job_, products, *fields_, observer_,
                                              [&](const RenderReport& so_far, int number, image::Picture&& picture) {
                                                  pictures.add(so_far, number, std::move(picture));
                                              });
    observer_.info(summary_of(*stream_, report, pictures));
    return pictures.count();
}

}  // namespace vvr::app
