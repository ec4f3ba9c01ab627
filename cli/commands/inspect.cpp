#include "cli/app/inspect.h"

#include <fmt/format.h>

#include "cli/app/input.h"
#include "cli/app/settings.h"
#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/options/job_options.h"
#include "cli/options/parse_value.h"
#include "core/base/error.h"
#include "core/image/atomic_file.h"
#include "core/image/picture_file.h"

namespace vvr::commands {

namespace {

namespace text {
constexpr Setting output{"output", "FILE", "the picture"};
constexpr Setting frame{"frame", "TIME", "which frame; the middle of the clip if not given, but at most 60s in"};
}  // namespace text

class Inspect final : public Command {
  public:
    void add_options(options::CommandLine& line) override {
        line.path(options::Group::output, job_.path, text::output,
                  {.letter = 'o',
                   .help = fmt::format(": {}; or a page to draw --roi and --mask on: .html",
                                       fmt::join(image::picture_file_extensions(), " ")),
                   .use = options::FileUse::written});
        options::add_input_options(line, job_.input, "INPUT...", options::clip_input);
        options::add_name_options(line, job_.input);
        options::add_join_option(line, job_.input);
        line.value(options::Group::input, text::frame, "",
                   [this](const std::string& given) { job_.frame = options::parse_time(given); });
        options::add_field_options(line, job_.fields);
        options::add_preset_option(line, options::Group::run);
        line.path(options::Group::look, job_.font, setting::font);
        options::add_thread_options(line, job_.fields.threads);
        line.examples({{"vvr inspect clip.avi --frame 1s -o frame.png", "object, flow and seeds of the frame at 1 s"},
                       {"vvr inspect clip.avi -o roi.html", "a page to draw --roi and --mask on"},
                       {"vvr inspect clip.avi --frame 1s --threshold 40 -o strict.png", "what a threshold leaves"}});
    }

    cli::ExitStatus run(const options::CommandLine&, const cli::Environment& environment) override {
        app::require_input(job_.input);
        if (job_.path.empty())
            throw Error(ErrorCode::output_missing, "no output: say where the picture goes with -o FILE");
        if (app::is_page(job_.path)) {
            image::check_file_path(job_.path);
        } else {
            image::check_picture_path(job_.path);
        }
        cli::Console console(environment, false);
        app::inspect(job_, console);
        return cli::ExitStatus::done;
    }

  private:
    app::InspectJob job_;
};

}  // namespace

std::unique_ptr<Command> make_inspect() {
    return std::make_unique<Inspect>();
}

}  // namespace vvr::commands
