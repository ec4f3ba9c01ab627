#include "cli/app/watch.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <ctime>
#include <deque>
#include <exception>
#include <filesystem>
#include <mutex>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/app/brick_films.h"
#include "cli/app/render.h"
#include "cli/compose/page_content.h"
#include "cli/observe/identify.h"
#include "cli/plan/input.h"
#include "cli/plan/make_plan.h"
#include "cli/plan/video_scale.h"
#include "cli/write/report.h"
#include "cli/write/write.h"
#include "core/annotation/lettering.h"
#include "core/annotation/time_ticks.h"
#include "core/base/text.h"
#include "core/fields/thresholds.h"
#include "core/footage/recorder_names.h"
#include "core/footage/recording.h"
#include "core/image/text.h"
#include "core/media/input.h"
#include "core/page/html.h"
#include "core/page/page.h"

namespace vvr::app {

namespace {

namespace fs = std::filesystem;
using Clock = media::LiveSource::Clock;

/// The times from a picture's last frame to the written file. Keeps the last thousand, to bound the memory.
class Latency {
  public:
    void add(double seconds) {
        constexpr std::size_t kept = 1000;
        last_.push_back(seconds);
        if (last_.size() > kept) last_.pop_front();
    }

    /// 0 = no pictures.
    double median() const {
        if (last_.empty()) return 0;
        std::vector<double> sorted(last_.begin(), last_.end());
        const auto middle = sorted.begin() + std::ssize(sorted) / 2;
        std::ranges::nth_element(sorted, middle);
        return *middle;
    }

    double longest() const { return last_.empty() ? 0 : std::ranges::max(last_); }

  private:
    std::deque<double> last_;
};

/// \param begin seconds since 1970 (UTC)
StartTime starts_at(std::int64_t begin, ClockSource source) {
    constexpr double longest = 400 * 86'400.0;  // seconds for which daylight saving time is computed
    vvr::Clock clock = local_clock(begin, longest, source);
    clock.zone.clear();  // it would list all zones of that period
    return {StartTime::From::given, clock};
}

/// A file was recorded earlier, so the current time of this machine doesn't apply.
StartTime start_time_from_name(const RenderJob& job, const std::string& file) {
    const footage::Segment named = footage::segment_from_name(file, footage::RecorderNames(job.input.name_patterns));
    if (!named.begin) return {StartTime::From::none};
    return starts_at(*named.begin, named.begin_source);
}

/// Whether the file was changed in the last few seconds.
bool grows(const fs::path& file) {
    constexpr std::chrono::seconds lately{10};
    std::error_code none;
    const auto written = fs::last_write_time(file, none);
    return !none && fs::file_time_type::clock::now() - written < lately;
}

std::unique_ptr<media::LiveSource> connect(const RenderJob& job, const StreamOptions& options, Observer& observer) {
    media::LiveOptions live;
    live.source.field_size = job.input.field_size;
    live.source.rate = job.input.rate;
    live.source.aspect = job.input.aspect;
    live.source.hwaccel = job.input.hwaccel;
    live.source.colour = wants_colour(job);
    live.patience = options.patience;
    live.duration = options.duration;
    live.report = [&observer](const std::string& text) { observer.warn(text); };
    return std::make_unique<media::LiveSource>(only_input(job.input), std::move(live));
}

/// Writes pictures and measures their latency.
class LivePictures {
  public:
    LivePictures(const Plan& plan, const media::LiveSource& stream, const page::RecentMoments& moments,
                 BrickFilms& films, Observer& observer)
        : plan_(plan),
          name_(plan.output.files.path),
          stream_(stream),
          moments_(moments),
          films_(films),
          observer_(observer),
          files_(plan.output.files, observer),
          outages_([this](const std::stop_token& stop) { look_for_outages(stop); }) {}

    void add(FinishedPicture&& finished) {
        const RunContext& context = finished.context;
        const Observation& seen = context.seen;
        for (; told_ < seen.relearnt.size(); ++told_) observer_.warn(seen.relearnt[told_]);
        const std::lock_guard lock(mutex_);
        if (failure_) std::rethrow_exception(failure_);
        record_ = record_of(context);
        add_lettering(finished);
        if (is_page(plan_.output.files.path)) {
            page::PageContent content = page_content(plan_, seen, context.composed);
            content.picture = std::move(finished.picture);
            content.settings = record_;
            content.moments = moments_.since(seen.begin.frame, seen.end().frame);
            films_.end_brick();
            content.films = films_.since(seen.begin.seconds);
            content.live = state_of(context);
            content.unseen.dropped = content.live->dropped;
            page_ = page::make_page(content);
        } else {
            picture_ = std::move(finished.picture);
        }
        number_ = finished.number;
        text_size_ = context.composed.framing.sheet.text;
        write();
        ++count_;
        check_clock(seen.end().seconds);
        const auto came = stream_.arrival(seen.end().frame);
        const double took = came ? std::chrono::duration<double>(Clock::now() - *came).count() : 0;
        if (came) latency_.add(took);
        observer_.info(fmt::format(
            "'{}': brick {}, {}, written {:.2f} s after its last frame", name_.at(finished.number).string(),
            finished.number,
            annotation::format_interval_and_zone(seen.begin.seconds, seen.end().seconds, plan_.read.clock), took));
    }

    /// Call it after the stream's last picture: whoever looks at the page learns that there will be no other.
    void end() {
        outages_.request_stop();
        outages_.join();
        if (failure_) std::rethrow_exception(failure_);
        if (!page_.empty()) files_.add_page(page::with_ended_stream(std::move(page_)));
    }

    std::int64_t count() const { return count_; }

    /// A summary of the stream in one line.
    std::string summary(const Observation& seen) const {
        return fmt::format(
            "'{}': {} of {} in {:.1f} s; {:.2f} s from frame to picture (median), {:.2f} s at most; {} dropped, {}, {}",
            stream_.info().name, counted(count_, "picture"), counted(seen.summary.frames, "frame"), seen.end().seconds,
            latency_.median(), latency_.longest(), counted(stream_.dropped(), "frame"),
            counted(stream_.reconnections(), "reconnection"), counted(seen.summary.damaged, "damaged packet"));
    }

  private:
    /// Writes the last picture or page. While there is no signal, it says so. Call it with the mutex held.
    void write() {
        lost_ = stream_.lost_since();
        const std::string text =
            lost_ ? fmt::format("no signal since {}", annotation::format_moment(*lost_, plan_.read.clock))
                  : std::string();
        if (!page_.empty()) {
            files_.add_page(lost_ ? page::with_state(page_, text) : page_);
        } else {
            image::Picture picture{picture_.pixels};
            const Size size = picture.pixels.size();
            const scene::Theme& theme = plan_.look.theme;
            annotation::Label label = annotation::make_centred_label(text, 2 * text_size_, size.width / 2.0,
                                                                     size.height / 2.0, image::Rgba(theme.fast, 1));
            label.halo = image::Rgba(theme.background, 1);
            annotation::Lettering words;
            words.labels.push_back(label);
            annotation::draw(picture, words);
            files_.add(number_, std::move(picture), record_);
        }
    }

    /// Writes the last picture again when the signal is lost or comes back. A series keeps its pictures.
    void look_for_outages(const std::stop_token& stop) {
        constexpr std::chrono::milliseconds often{200};
        std::unique_lock lock(mutex_);
        while (!stopped_.wait_for(lock, stop, often, [] { return false; }) && !stop.stop_requested() && !failure_) {
            if (count_ == 0 || name_.has_field() || stream_.lost_since() == lost_) continue;
            try {
                write();
            } catch (...) {
                failure_ = std::current_exception();
            }
        }
    }

    /// Warns once if the stream comes faster than it was recorded: then its end can't be now.
    /// \param end of the picture, seconds of the stream
    void check_clock(double end) {
        constexpr double little = 5;  // seconds; a server may send what it has kept
        const double passed = std::chrono::duration<double>(Clock::now() - began_).count();
        const bool is_live = plan_.read.clock && plan_.read.clock->source == ClockSource::live;
        if (!is_live || end < passed + little || std::exchange(is_ahead_, true)) return;
        observer_.warn(
            fmt::format("'{}' comes faster than it was recorded, so its times of day are ahead of the clock; give "
                        "--start-time none, or the time at which it begins",
                        stream_.info().name));
    }

    page::LiveState state_of(const RunContext& context) const {
        page::LiveState state;
        state.text = is_learning(context.seen) ? "learning the empty scene" : "watching";
        state.dropped = stream_.dropped();
        state.written = std::time(nullptr);
        const std::int64_t newest = context.composed.bricks.back().count * context.seen.volume.step();
        state.brick_seconds = static_cast<double>(newest) / context.seen.info.rate;
        return state;
    }

    /// Whether the reference may still contain objects that were there when the stream began.
    bool is_learning(const Observation& seen) const {
        constexpr double ghosts_until = fields::thresholds.scene.live + fields::thresholds.running.ghost;
        return plan_.field.reference != nullptr && plan_.field.reference->adapts && seen.end().seconds < ghosts_until;
    }

    const Plan& plan_;
    image::NamePattern name_;
    const media::LiveSource& stream_;
    const page::RecentMoments& moments_;
    BrickFilms& films_;
    Observer& observer_;
    PictureOutput files_;
    Latency latency_;
    std::int64_t count_ = 0;
    std::size_t told_ = 0;  ///< of the observation's sentences about the empty scene
    Clock::time_point began_ = Clock::now();
    bool is_ahead_ = false;

    std::mutex mutex_;  ///< of the following
    std::condition_variable_any stopped_;
    std::string page_;        ///< the last one
    image::Picture picture_;  ///< the last one, if there is no page
    image::Metadata record_;
    int number_ = 0;
    int text_size_ = 0;
    std::optional<double> lost_;  ///< as the picture says
    std::exception_ptr failure_;
    std::jthread outages_;  ///< last member, so it is joined first
};

/// The job with the name and start time of the stream.
/// \param camera as the user names it; may be empty
RenderJob for_stream(RenderJob job, const std::string& camera, const std::string& name, bool is_file) {
    if (job.look.title.empty()) job.look.title = camera;
    if (job.look.title.empty()) {
        // The whole URL: its last part alone says too little.
        const std::string shown = media::is_url(name) ? name.substr(name.find("://") + 3) : shown_name(name);
        job.look.title = shown == "stdin" ? "Live" : shown;
    }
    if (job.look.start_time.from == StartTime::From::automatic) {
        job.look.start_time =
            is_file ? start_time_from_name(job, name) : starts_at(std::time(nullptr), ClockSource::live);
    }
    return job;
}

}  // namespace

StreamWatch::StreamWatch(const RenderJob& job, const StreamOptions& options, Observer& observer)
    : observer_(observer), options_(options) {
    validate(job);
    validate_series(job);
    auto detector = open_detector(job.detector);
    auto connected = connect(job, options, observer);
    stream_ = connected.get();
    const std::string& name = stream_->info().name;
    std::error_code none;
    const bool is_file = fs::is_regular_file(name, none);
    if (is_file) {
        observer.warn(
            grows(name)
                ? fmt::format("'{}' is a growing file, not a live stream; vvr ends where it ends now; `tail "
                              "-c +1 -f` piped into `vvr watch -` follows it",
                              name)
                : fmt::format("'{}' is a complete file, not a live stream; `vvr render` draws all of it", name));
    }
    if (options_.camera.empty()) {
        const footage::RecorderNames names(job.input.name_patterns);
        options_.camera =
            job.look.title.empty() && is_file ? footage::segment_from_name(name, names).camera : job.look.title;
    }
    OpenedFields opened;
    opened.span = job.fields.span;
    opened.source = with_listed_seeds(std::make_unique<fields::ClipFields>(std::move(connected), field_options_of(job)),
                                      job, *job.fields.filter, false);
    plan_ = std::make_unique<const Plan>(make_plan(for_stream(job, options.camera, name, is_file), opened.facts(),
                                                   Purpose::stream, std::move(detector)));
    fields_ = std::move(opened.source);
}

tracking::EventLine StreamWatch::line_of_time(double first, double last, std::string_view kind) const {
    const WallClock& clock = plan_->read.clock;
    const auto time = [&](double seconds) {
        return clock ? std::optional(clock->iso(seconds)) : std::optional<std::string>();
    };
    tracking::EventLine line{.camera = options_.camera, .clip = redact_secrets(stream_->info().name), .kind = kind};
    line.first = first;
    line.last = last;
    line.begin = time(first);
    line.end = time(last);
    return line;
}

tracking::EventLine StreamWatch::line_of(const tracking::Event& event, std::size_t number) const {
    tracking::EventLine line = line_of_time(event.first.seconds, event.last.seconds, tracking::name_of(event.kind));
    line.number = number;
    if (event.identity) line.what = event.identity->what;
    line.open_ended = event.open_ended;
    line.box = VideoScale(plan_->read.clip.field_size, stream_->info().size)(event.box);
    line.direction = tracking::direction_of(event);
    if (const fs::path& page = page_of(plan_->output.files); !page.empty())
        line.page = fmt::format("{}#event={}", page::url_of_path(page.filename().string()), number);
    return line;
}

/// Reports the intervals in which the recording was at fault, each once.
/// \param until time at which they must have ended, seconds
void StreamWatch::report_intervals(const Observation& seen, double until) {
    if (!options_.on_event) return;
    for (const condition::Interval& interval : unseen_of(*plan_, seen).intervals) {
        double& reported = reported_[static_cast<std::size_t>(interval.kind)];
        if (interval.end <= reported || interval.end > until) continue;
        reported = interval.end;
        options_.on_event(line_of_time(interval.begin, interval.end, row_of(interval.kind).name));
    }
}

std::int64_t StreamWatch::run() {
    check_memory(plan_->volume.extent);
    const media::VideoInfo& info = stream_->info();
    observer_.info(
        fmt::format("'{}': {}x{}, {:.4g} frames per second", info.name, info.size.width, info.size.height, info.rate));
    page::RecentMoments moments(info.size, plan_->volume.window.frames());
    BrickFilms films(*plan_, info, observer_);
    const FrameWatch watch{{}, [&](const media::SharedFrame& frame, const fields::Field& field) {
                               moments.add(*frame, field);
                               films.add(frame);
                           }};
    LivePictures pictures(*plan_, *stream_, moments, films, observer_);
    EndedSink ended;
    if (options_.on_event) {
        ended = [this](const tracking::Event& event, std::size_t number) { options_.on_event(line_of(event, number)); };
    }
    const Outcome done = render_series(
        *plan_, *fields_, observer_,
        [&](FinishedPicture&& picture) {
            constexpr double at_once = 1;  // seconds; an interval that goes on is one
            report_intervals(picture.context.seen, picture.context.seen.end().seconds - at_once);
            pictures.add(std::move(picture));
        },
        ended, watch);
    report_intervals(done.seen, done.seen.end().seconds);
    pictures.end();
    observer_.info(pictures.summary(done.seen));
    return pictures.count();
}

}  // namespace vvr::app
