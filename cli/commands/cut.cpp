#include "cli/app/cut.h"

#include <chrono>
#include <optional>
#include <stop_token>
#include <thread>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/app/input.h"
#include "cli/app/settings.h"
#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/options/job_options.h"
#include "cli/options/output.h"
#include "cli/options/parse_value.h"
#include "core/base/error.h"
#include "core/base/setting.h"
#include "core/video/container.h"

namespace vvr::commands {

namespace {

namespace text {
constexpr Setting output{
    "output", "FILE", "the piece; its extension names the container, and is chosen if there is none, or for a folder"};
constexpr Setting event{
    "event", "N", "cut this event, by its number in the picture, the report and the page", {1, 1'000'000'000}};
constexpr Setting report{"report", "FILE", "read the events from this report of `vvr render --report`; no search"};
constexpr Setting from{"from", "TIME",
                       "cut from here; the beginning if not given; as --start, by the clock on the wall too"};
constexpr Setting to{"to", "TIME", "the first frame that is no longer in the piece; the end if not given"};
constexpr Setting margin{"margin", "TIME", "so much more before and after", {0, 3600}};
constexpr Setting exact{"exact", "",
                        "encode exactly these frames anew, without sound; else packets are copied from the key frame "
                        "before"};
}  // namespace text

class Cut final : public Command {
  public:
    void add_options(options::CommandLine& line) override {
        constexpr options::Group output = options::Group::output;
        line.path(output, job_.path, text::output,
                  {.letter = 'o',
                   .help = fmt::format(": {}", fmt::join(names_of(video::containers()), " ")),
                   .use = options::FileUse::written});
        line.value(output, text::event, "", [this](const std::string& given) {
            job_.event = options::parse_integer(given, static_cast<std::int64_t>(text::event.range.low),
                                                static_cast<std::int64_t>(text::event.range.high));
        });
        line.path(output, job_.report, text::report, {.use = options::FileUse::read});
        line.value(output, text::from, "",
                   [this](const std::string& given) { set(given, job_.from, job_.asked.start); });
        line.value(output, text::to, "", [this](const std::string& given) { set(given, job_.to, job_.asked.end); });
        line.duration(output, job_.margin, text::margin);
        line.flag(output, job_.exact, text::exact);
        line.exclude(text::event, text::from);
        line.exclude(text::event, text::to);
        line.exclude(text::report, text::from);
        line.exclude(text::report, text::to);
        // The options that decide which events exist, and their numbers.
        app::RenderJob& search = job_.search;
        options::add_event_options(line, output, search.output.events);
        options::add_input_options(
            line, search.input, "INPUT...",
            "a video file; files, folders, a pattern ('gate/*.mp4') or a list (.txt) of files that are one "
            "recording");
        options::add_name_options(line, search.input);
        options::add_join_option(line, search.input);
        options::add_start_time_option(line, search.look.start_time);
        options::add_span_options(line, search.fields.span);
        options::add_field_options(line, search.fields);
        options::add_preset_option(line, options::Group::run);
        options::add_thread_options(line, search.fields.threads);
        line.examples(
            {{"vvr cut clip.avi -o event.mkv --event 1", "the first event of the clip's picture"},
             {"vvr cut clip.avi -o piece.avi --from 0.5s --to 00:00:01.5", "a piece, copied from the key frame before"},
             {"vvr cut clip.avi -o exact.mp4 --from 5f --to 15f --exact", "exactly these frames, encoded again"}});
    }

    cli::ExitStatus run(const options::CommandLine&, const cli::Environment& environment) override {
        app::require_input(job_.search.input);
        if (job_.path.empty())
            throw Error(ErrorCode::output_missing, "no output: say where the piece goes with -o FILE");
        if (!job_.event && !job_.from && !job_.to && !job_.asked.start && !job_.asked.end) {
            throw Error(ErrorCode::usage, "no piece: say which with --event N, or with --from TIME --to TIME");
        }
        cli::Console console(environment);
        const std::stop_source stop;
        environment.signals.set_exit_hook([stop]() mutable { stop.request_stop(); });
        if (!app::cut(job_, console, stop.get_token())) {
            // A signal has stopped it, and is about to end the program.
            for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
        }
        environment.signals.set_exit_hook({});
        return cli::ExitStatus::done;
    }

  private:
    /// Stores a time of the clip or a wall-clock time.
    static void set(const std::string& given, std::optional<app::Time>& time,
                    std::optional<video::RequestedTime>& asked) {
        const auto place = options::parse_place(given);
        time = std::holds_alternative<app::Time>(place) ? std::optional(std::get<app::Time>(place)) : std::nullopt;
        asked = time ? std::nullopt : std::optional(std::get<video::RequestedTime>(place));
    }

    app::CutJob job_;
};

}  // namespace

std::unique_ptr<Command> make_cut() {
    return std::make_unique<Cut>();
}

}  // namespace vvr::commands
