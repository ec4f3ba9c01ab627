#include "cli/options/watch.h"

#include <algorithm>

#include <fmt/format.h>

#include "cli/app/input.h"
#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/options/job_options.h"
#include "core/base/error.h"
#include "core/fields/reference.h"

namespace vvr::commands {

namespace {

class Watch final : public Command {
  public:
    Watch() {
        // A live stream can't have a reference that needs the whole clip.
        job_.fields.reference =
            std::string(std::ranges::find_if(fields::reference_kinds(), &fields::ReferenceRow::adapts)->name);
    }

    void add_options(options::CommandLine& line) override {
        line.set_for_streams();
        options::add_stream_output(line, job_.output);
        options::add_stream_options(line, options_);
        options::add_input_options(
            line, job_.input, "INPUT",
            "a URL (rtsp://..., http://...), a camera's device (/dev/video0), a file that grows, - for "
            "stdin, @FILE for a URL that a file holds");
        options::add_picture_options(line, job_);
        options::add_stream_clock(line, job_.look.start_time);
        line.examples(
            {{"vvr watch rtsp://camera/stream -o gate.html", "a page that shows the last 80 seconds"},
             {"vvr watch rtsp://camera/stream -o gate.png --brick 1m --window 10 --duration 8h",
              "a picture of the last ten minutes, for a working day"},
             {"vvr watch rtsp://camera/stream -o 'gate.{brick:6}.png'", "a picture each 10 seconds, all kept"}});
    }

    cli::ExitStatus run(const options::CommandLine& line, const cli::Environment& environment) override {
        options::check_stream(job_);
        job_.input.names = {options::address_of(app::only_input(job_.input))};
        options::finish(line, job_, true);
        cli::Console console(environment, false);
        app::StreamWatch watch(job_, options_, console);
        const cli::GracefulShutdown stop(environment.signals, [&watch] { watch.stop(); });
        if (watch.run() == 0 && !stop.asked()) {
            const fields::ReferenceRow* const reference = job_.fields.reference.row();
            const bool learns = reference != nullptr && reference->adapts;
            throw Error(ErrorCode::not_video,
                        fmt::format("'{}' ended before the first picture: {}", watch.name(),
                                    learns ? "its first two seconds only served to learn the empty scene; watch it for "
                                             "longer, or choose --reference first or a picture"
                                           : "watch it for longer, or choose a shorter --brick"));
        }
        return cli::ExitStatus::done;
    }

  private:
    app::RenderJob job_;
    app::StreamOptions options_;
};

}  // namespace

std::unique_ptr<Command> make_watch() {
    return std::make_unique<Watch>();
}

}  // namespace vvr::commands
