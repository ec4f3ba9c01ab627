#include "cli/app/stored_flow_seeds.h"
#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/options/job_options.h"
#include "core/base/error.h"

namespace vvr::commands {

namespace {

namespace text {
constexpr Setting output{"output", "DIR", "a new or empty folder for the lists, which `vvr render --seeds DIR` reads"};
}  // namespace text

class Seeds final : public Command {
  public:
    void add_options(options::CommandLine& line) override {
        line.arguments(flows_, "FLOW", "a folder that `vvr extract` wrote, or one with .flo files, named by frame");
        line.path(options::Group::output, job_.folder, text::output, {.letter = 'o', .use = options::FileUse::written});
        options::add_seed_options(line, job_.seeds);
        line.examples({{"vvr extract clip.avi -o data", "the flow of a clip"},
                       {"vvr seeds data -o lists --seed-select first:2", "the two fastest points of each frame"},
                       {"vvr render clip.avi -o clip.png --seeds lists", "the picture with arrows at those"}});
    }

    cli::ExitStatus run(const options::CommandLine&, const cli::Environment& environment) override {
        if (flows_.size() != 1)
            throw Error(flows_.empty() ? ErrorCode::input_missing : ErrorCode::input_unsuitable,
                        "seeds need one FLOW: the folder of an extraction, or of .flo files");
        if (job_.folder.empty())
            throw Error(ErrorCode::output_missing, "no output: say where the lists go with -o DIR");
        job_.flow = flows_.front();
        cli::Console console(environment);
        app::write_seeds(job_, console);
        return cli::ExitStatus::done;
    }

  private:
    app::StoredFlowSeedsJob job_;
    std::vector<std::string> flows_;
};

}  // namespace

std::unique_ptr<Command> make_seeds_command() {
    return std::make_unique<Seeds>();
}

}  // namespace vvr::commands
