#include "cli/commands/render.h"

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "cli/app/render.h"
#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/options/job_options.h"
#include "cli/plan/input.h"
#include "core/base/error.h"

namespace vvr::commands {

namespace {

class Render final : public Command {
  public:
    void add_options(options::CommandLine& line) override {
        add_render_options(line, job_);
        line.examples({{"vvr render clip.avi -o clip.png", "the whole clip as one picture"},
                       {"vvr render clip.avi -o clip.html --report clip.json",
                        "a page to watch the clip from, and its events for programs"},
                       {"vvr render 'recordings/2026-11-21/*/gate' -o gate.png --preset day",
                        "all files of a recorder's day as one picture"}});
    }

    cli::ExitStatus run(const options::CommandLine& line, const cli::Environment& environment) override {
        check_meant_output();
        prepare_render(line, job_);
        cli::Console console(environment);
        app::require_whole(app::render(job_, console).info);
        return cli::ExitStatus::done;
    }

  private:
    /// Detects `vvr render clip.avi out.png`: the last name is a missing file, probably meant as the output.
    void check_meant_output() const {
        const app::OutputOptions& output = job_.output;
        const std::vector<std::string>& names = job_.input.names;
        if (!output.path.empty() || output.lists_events() || !output.golden.path.empty() || names.size() < 2) return;
        std::error_code none;
        const std::string& last = names.back();
        if (std::filesystem::exists(last, none)) return;
        throw Error(
            ErrorCode::output_missing,
            fmt::format("no output given, and the input '{0}' does not exist; if it is the output, write -o '{0}'",
                        last));
    }

    app::RenderJob job_;
};

}  // namespace

void add_render_options(options::CommandLine& line, app::RenderJob& job) {
    options::add_output_options(line, job.output);
    options::add_recording_options(line, job.input, options::clip_or_extraction_input);
    options::add_picture_options(line, job);
}

void prepare_render(const options::CommandLine& line, app::RenderJob& job) {
    options::check(job.output);
    options::finish(line, job, app::is_series(job.output));
    options::check_outputs(job);
    app::require_input(job.input);
}

std::unique_ptr<Command> make_render() {
    return std::make_unique<Render>();
}

}  // namespace vvr::commands
