#include "cli/app/watch.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/event_file.h"
#include "cli/options/command_line.h"
#include "cli/options/job_options.h"
#include "cli/plan/input.h"
#include "cli/plan/settings.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/fields/reference.h"
#include "core/image/picture_file.h"
#include "core/image/video_encoder.h"

namespace vvr::commands {

namespace {

constexpr Setting output{"output", "FILE", "the picture; it is replaced after each brick"};

void add_stream_options(options::CommandLine& line, app::StreamOptions& stream) {
    const options::AddOptions add(line, options::Group::input);
    add(setting::duration, stream.duration);
    add(setting::patience, stream.patience);
}

void add_stream_output(options::CommandLine& line, app::OutputOptions& options) {
    options::AddOptions(line, options::Group::output)(
        output, options.path,
        {.letter = 'o',
         .help =
             fmt::format(": {}; a page that reloads itself: .html; a series, one file per brick, has a field in its "
                         "name: {{brick:4}}, #### or %04d",
                         fmt::join(image::picture_file_extensions(), " ")),
         .use = options::FileUse::written});
}

/// The address of an input: the input itself, or for `@FILE` the first line of that file. Other users of the machine
/// can see a program's arguments, but not such a file.
/// \throws Error io when the file can't be read, usage when it holds no address
std::string address_of(const std::string& input) {
    if (!input.starts_with('@')) return input;
    const std::string file = input.substr(1);
    std::istringstream lines(read_file(file, most_bytes::text));
    std::string address;
    std::getline(lines, address);
    while (!address.empty() && std::isspace(static_cast<unsigned char>(address.back())) != 0) address.pop_back();
    if (!address.empty()) return address;
    throw Error(
        ErrorCode::input_missing,
        fmt::format("the file '{}' has no address; write one into its first line, such as rtsp://camera/stream", file));
}

/// \throws Error usage for options that need a clip with an end
void check_stream(const app::RenderJob& job) {
    if (job.output.path.empty())
        throw Error(ErrorCode::output_missing, "no output given; name the file for the picture with -o FILE");
    options::check(job.output);
    if (image::is_animation(job.output.path)) {
        throw Error(
            ErrorCode::output_format_unknown,
            fmt::format("'{}': an animated file is complete at its end, but a stream has none; use a picture, a "
                        "page or a series",
                        job.output.path.string()));
    }
    using From = app::StartTime::From;
    const From clock = job.look.start_time.from;
    if (clock == From::recorded || clock == From::container || clock == From::modified) {
        throw Error(ErrorCode::choice_unknown,
                    fmt::format("{}: {}", setting::start_time.name, setting::start_time.not_live_reason),
                    {setting::start_time.name});
    }
    const fields::ReferenceRow* const reference = job.fields.reference.row();
    struct {
        bool given;
        std::string option;
        const char* instead;
    } const refused[] = {
        {std::filesystem::is_directory(job.seeds), "--seeds",
         "a stream can't have one list per frame; use one list for all frames"},
        {job.fields.flow.method.is_folder(), "--flow " + job.fields.flow.method.name(),
         "a stream's frames have no flow yet; choose a method"},
        {reference != nullptr && reference->needs_whole_clip, "--reference " + job.fields.reference.name(),
         "it needs the whole clip; use running, first or a picture"},
    };
    for (const auto& row : refused) {
        if (row.given) throw Error(ErrorCode::options_conflict, fmt::format("{}: {}", row.option, row.instead));
    }
}

class Watch final : public Command {
  public:
    Watch() {
        // A live stream can't have a reference that needs the whole clip.
        job_.fields.reference =
            std::string(std::ranges::find_if(fields::reference_kinds(), &fields::ReferenceRow::adapts)->name);
    }

    void add_options(options::CommandLine& line) override {
        line.set_for_streams();
        add_stream_output(line, job_.output);
        add_stream_options(line, options_);
        line.find_camera(options_.camera);
        options::add_input_options(
            line, job_.input, "INPUT",
            "a URL (rtsp://..., http://...), a camera's device (/dev/video0), - for stdin, a file up to its end, "
            "@FILE for a URL in a file");
        options::add_picture_options(line, job_);
        options::add_events_to_option(line, options::Group::output, events_to_);
        options::AddOptions(line, options::Group::look)(setting::stream_clock, job_.look.start_time);
        line.examples(
            {{"vvr watch rtsp://camera/stream -o gate.html", "a page of the last 80 seconds"},
             {"vvr watch rtsp://camera/stream -o gate.png --brick 1m --window 10 --duration 8h",
              "a picture of the last ten minutes, for eight hours"},
             {"vvr watch rtsp://camera/stream -o gate.html --events-to events.jsonl",
              "also a line of JSON for each event that has ended"},
             {"vvr watch rtsp://camera/stream -o 'gate.{brick:6}.png'", "one picture every 10 seconds, all kept"}});
    }

    cli::ExitStatus run(const options::CommandLine& line, const cli::Environment& environment) override {
        check_stream(job_);
        job_.input.names = {address_of(app::only_input(job_.input))};
        options::finish(line, job_, true);
        options::check_events_to(events_to_, job_);
        cli::Console console(environment, false);
        cli::EventFile events(events_to_, environment.log);
        job_.output.reports_events = !events_to_.empty();
        if (job_.output.reports_events) {
            options_.on_event = [&events](const tracking::EventLine& one) { events.add(one); };
        }
        app::StreamWatch watch(job_, options_, console);
        const cli::GracefulShutdown stop(environment.signals, [&watch] { watch.stop(); });
        if (watch.run() == 0 && !stop.asked()) {
            const fields::ReferenceRow* const reference = job_.fields.reference.row();
            const bool learns = reference != nullptr && reference->adapts;
            throw Error(ErrorCode::not_video,
                        fmt::format("'{}' ended before the first picture: {}", watch.name(),
                                    learns ? "its first 50 frames only served to learn the empty scene; watch it for "
                                             "longer, or choose --reference first or a picture"
                                           : "watch it for longer, or choose a shorter --brick"));
        }
        return events.finish() ? cli::ExitStatus::done : cli::ExitStatus::io;
    }

  private:
    app::RenderJob job_;
    std::filesystem::path events_to_;
    app::StreamOptions options_;
};

}  // namespace

std::unique_ptr<Command> make_watch() {
    return std::make_unique<Watch>();
}

}  // namespace vvr::commands
