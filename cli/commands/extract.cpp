#include "cli/app/extract.h"

#include "cli/app/input.h"
#include "cli/app/settings.h"
#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/options/job_options.h"
#include "cli/options/parse_value.h"
#include "core/base/error.h"

namespace vvr::commands {

namespace {

namespace text {
constexpr Setting output{"output", "DIR", "a new or empty folder, or one with an older extraction, which is replaced"};
constexpr Setting with_color{"with-color", "", "keep every frame's picture, for renders with --color video"};
constexpr Setting part{"part", "I/N",
                       "only the I-th of N parts of the clip, 1/N to N/N, as from one extraction of all of it"};
}  // namespace text

class Extract final : public Command {
  public:
    void add_options(options::CommandLine& line) override {
        constexpr options::Group output = options::Group::output;
        line.path(output, job_.folder, text::output, {.letter = 'o', .use = options::FileUse::written});
        // Not in Group::fields: it decides what is stored, not how a field is computed.
        line.number(output, job_.fields.flow.every, setting::flow_every);
        line.flag(output, job_.colour, text::with_color);
        // The recorded settings have the part as --start and --end.
        line.value(output, text::part, "",
                   [this](const std::string& given) { job_.part = options::parse_share(given); });
        options::add_input_options(line, job_.input, "INPUT...", options::clip_input);
        options::add_name_options(line, job_.input);
        options::add_join_option(line, job_.input);
        options::add_span_options(line, job_.fields.span);
        options::add_field_options(line, job_.fields);
        options::add_preset_option(line, options::Group::run);
        options::add_start_time_option(line, job_.start_time);
        options::add_thread_options(line, job_.fields.threads);
        line.examples({{"vvr extract clip.avi -o data", "fields, flow and seeds as files"},
                       {"vvr render data -o data.png", "the picture of them"},
                       {"vvr extract clip.avi -o part --part 2/8 --with-color", "one of eight parts of a long clip"}});
    }

    cli::ExitStatus run(const options::CommandLine& line, const cli::Environment& environment) override {
        if (job_.folder.empty())
            throw Error(ErrorCode::output_missing, "no output: say where the files go with -o DIR");
        app::require_input(job_.input);
        job_.settings = options::shown(line.values(std::array{options::Group::input, options::Group::fields}));
        cli::Console console(environment);
        app::extract(job_, console);
        return cli::ExitStatus::done;
    }

  private:
    app::ExtractJob job_;
};

}  // namespace

std::unique_ptr<Command> make_extract() {
    return std::make_unique<Extract>();
}

}  // namespace vvr::commands
