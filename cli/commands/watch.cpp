#include "cli/options/watch.h"

#include <chrono>
#include <ctime>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cli/command_line.h"
#include "cli/commands/command.h"
#include "cli/render/latency.h"
#include "cli/render/picture_output.h"
#include "cli/render/picture_settings.h"
#include "cli/render/plan.h"
#include "cli/render/render_series.h"
#include "cli/render/shown_name.h"
#include "core/labels/time_ticks.h"
#include "core/page/live_page.h"
#include "core/video/input.h"
#include "core/video/live_source.h"
#include "core/words.h"

namespace vvr {

namespace {

using Clock = LiveSource::Clock;

/// What the clock on the wall shows, as if it were of UTC.
std::int64_t wall_clock_now() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    localtime_r(&now, &parts);
    return timegm(&parts);
}

std::unique_ptr<LiveSource> connect(const RenderSettings& settings, const WatchOptions& options, spdlog::logger& log) {
    LiveOptions live;
    live.source.field_size = settings.input.field_size;
    live.source.rate = settings.input.rate;
    live.source.colour = wants_colour(settings);
    live.lag = options.lag;
    live.patience = options.patience;
    live.duration = options.duration;
    live.tell = [&log](const std::string& text) { log.warn("{}", text); };
    return std::make_unique<LiveSource>(only_input(settings.input), std::move(live));
}

/// A stream's address tells more than the last part of it does.
std::string title_of(const RenderSettings& settings, const LiveSource& stream) {
    const std::string& name = stream.info().name;
    if (!settings.look.title.empty()) return settings.look.title;
    return is_url(name) ? name.substr(name.find("://") + 3) : shown_name(name);
}

RenderJob job_of(const RenderSettings& settings, const OutputOptions& output, const LiveSource& stream) {
    RenderJob job = job_for(settings);
    job.title = title_of(settings, stream);
    job.series = true;
    job.pixel_data = !is_page(output) && holds_pixel_data(output.path);
    job.clock = settings.look.start_time.clock ? settings.look.start_time.clock : wall_clock_now();
    return job;
}

/// Pictures on their way to the disk, and how long they took.
class Pictures {
  public:
    Pictures(const CommandLine& line, const OutputOptions& output, const RenderJob& job, const LiveSource& stream,
             const Environment& environment)
        : line_(line),
          output_(output),
          name_(output.path),
          job_(job),
          stream_(stream),
          environment_(environment),
          files_(output, environment.signals) {}

    void add(const RenderReport& report, int number, Picture&& picture) {
        const Metadata settings = describe(line_, {}, report, true);
        if (is_page(output_)) {
            files_.add_page(page_of(report, settings, std::move(picture)));
        } else {
            files_.add(number, picture, settings);
        }
        ++count_;
        const auto came = stream_.arrival(report.last_frame);
        const double took = came ? std::chrono::duration<double>(Clock::now() - *came).count() : 0;
        if (came) latency_.add(took);
        environment_.log.info("'{}': brick {}, {}, {:.2f} s after its last frame", name_.at(number).string(), number,
                              format_span(report.first_pts, report.last_pts, job_.clock), took);
    }

    std::int64_t count() const { return count_; }
    const Latency& latency() const { return latency_; }

  private:
    std::string page_of(const RenderReport& report, const Metadata& settings, Picture&& picture) const {
        LivePageContent page;
        page.name = job_.title;
        page.state = format_span(report.first_pts, report.last_pts, job_.clock);
        if (const auto lost = stream_.dropped()) page.state += fmt::format(", {} dropped", counted(lost, "frame"));
        page.span = fmt::format("{:.0f} s", report.last_pts - report.first_pts);
        page.picture = std::move(picture);
        page.settings = settings;
        page.written = std::time(nullptr);
        page.brick_seconds = static_cast<double>(report.bricks.back().count * report.step) / report.info.rate;
        return make_live_page(page);
    }

    const CommandLine& line_;
    const OutputOptions& output_;
    NamePattern name_;
    const RenderJob& job_;
    const LiveSource& stream_;
    const Environment& environment_;
    PictureOutput files_;
    Latency latency_;
    std::int64_t count_ = 0;
};

std::string summary_of(const LiveSource& stream, const RenderReport& report, const Pictures& pictures) {
    return fmt::format(
        "'{}': {} of {} in {:.1f} s; {:.2f} s from frame to picture (median), {:.2f} s at most; {} "
        "dropped, {}, {}",
        stream.info().name, counted(pictures.count(), "picture"), counted(report.frames, "frame"), report.last_pts,
        pictures.latency().median(), pictures.latency().longest(), counted(stream.dropped(), "frame"),
        counted(stream.reconnections(), "reconnection"), counted(report.damaged, "damaged packet"));
}

}  // namespace

ExitStatus run_watch(const Command& command, Arguments arguments, const Environment& environment) {
    RenderSettings settings;
    settings.fields.reference = "running";  // a median would have to wait for the end
    OutputOptions output;
    WatchOptions options;
    CommandLine line(command.name, command.help);
    add_stream_output(line.app(), output);
    add_options(line.app(), options);
    add_options(line.app(), settings);
    if (!line.parse(arguments)) return ExitStatus::done;
    apply(settings.run, environment.log);
    check_stream(settings, output);

    auto connected = connect(settings, options, environment.log);
    LiveSource& stream = *connected;
    const RenderJob job = job_of(settings, output, stream);
    FieldOptions field_options = settings.fields;
    field_options.threads = settings.run.threads;
    ClipFields fields(std::move(connected), field_options);
    check_memory(make_plan(job, fields));
    environment.log.info("'{}': {}x{}, {:.4g} frames a second", stream.info().name, stream.info().size.width,
                         stream.info().size.height, stream.info().rate);

    Pictures pictures(line, output, job, stream, environment);
    const PoliteStop stop(environment.signals, [&stream] { stream.stop(); });
    const RenderReport report =
        render_series(job, fields, {}, [&](const RenderReport& so_far, int number, Picture&& picture) {
            pictures.add(so_far, number, std::move(picture));
        });
    environment.log.info("{}", summary_of(stream, report, pictures));
    if (pictures.count() == 0 && !stop.asked()) {
        throw Error(ErrorKind::not_video,
                    fmt::format("'{}' ended before the first picture: its first two seconds only tell what the empty "
                                "scene is; watch it for longer, or take --reference first or a picture",
                                stream.info().name));
    }
    return ExitStatus::done;
}

}  // namespace vvr
