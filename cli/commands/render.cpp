#include "cli/render/render.h"

#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/options/job_options.h"
#include "cli/options/output.h"
#include "cli/render/open_fields.h"

namespace vvr {

namespace {

class Render final : public Command {
  public:
    void add_options(CommandLine& line) override {
        add_output_options(line, job_.output);
        add_input_options(line, job_.input, "INPUT...", clip_or_extraction_input);
        add_layout_options(line, job_.input);
        add_picture_options(line, job_);
        line.examples({{"vvr render clip.avi -o clip.png", "the whole clip as one picture"},
                       {"vvr render clip.avi -o clip.html --report clip.json",
                        "a page to watch the clip from, and its events for programs"},
                       {"vvr render 'recordings/2026-11-21/*/gate' -o gate.png --preset day",
                        "all files of a recorder's day as one picture"}});
    }

    ExitStatus run(const CommandLine& line, const Environment& environment) override {
        check(job_.output);
        finish(line, job_, is_series(job_.output));
        check_outputs(job_);
        require_input(job_.input);
        Console console(environment);
        render(job_, console);
        return ExitStatus::done;
    }

  private:
    RenderJob job_;
};

}  // namespace

std::unique_ptr<Command> make_render() {
    return std::make_unique<Render>();
}

}  // namespace vvr
