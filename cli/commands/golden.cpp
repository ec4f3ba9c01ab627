#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/app/render.h"
#include "cli/commands/command.h"
#include "cli/commands/golden_cases.h"
#include "cli/commands/golden_results.h"
#include "cli/console.h"
#include "cli/options/add_option.h"
#include "cli/plan/input.h"
#include "core/archive/output_files.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"

namespace vvr::commands {

namespace {

namespace golden_text {
constexpr Setting bless{"bless", "", "replace the golden pictures instead of comparing"};
constexpr Setting diffs{"diffs", "", "write a picture of the differences beside each golden picture: NAME.diff.png"};
constexpr Setting junit{"junit", "FILE", "the results as JUnit XML, for CI systems"};
constexpr Setting report{"report", "FILE", "the results as JSON; - = standard output"};
}  // namespace golden_text

GoldenVerdict verdict_of(ErrorCode code) {
    if (code == ErrorCode::picture_differs) return GoldenVerdict::differs;
    return code == ErrorCode::reference_missing ? GoldenVerdict::missing : GoldenVerdict::failed;
}

/// Draws and compares one picture. An error about it is its result.
GoldenResult result_of(GoldenCase& one, const cli::Environment& environment) {
    GoldenResult result{one.name, one.job.output.golden.bless ? GoldenVerdict::blessed : GoldenVerdict::same};
    one.job.output.golden.compared = [&result](const image::Comparison& comparison) {
        if (comparison.has_numbers()) result.numbers = {comparison.percent, comparison.patch, comparison.max};
    };
    const auto begin = std::chrono::steady_clock::now();
    try {
        if (one.fault) throw Error(*one.fault);
        // Nobody has named these files, and a link in the folder may lead anywhere.
        const app::GoldenOptions& golden = one.job.output.golden;
        if (golden.bless) archive::check_own_place(golden.path);
        archive::check_own_place(golden.comparison.diff);
        cli::Console console(environment);
        app::require_whole(app::render(one.job, console).info);
    } catch (const Error& error) {
        result.verdict = verdict_of(error.code());
        result.code = error.code();
        result.reason = cli::with_flags(error.what(), error.about());
        cli::log_error(environment.log, error.code(), fmt::format("{}: {}", one.name, result.reason));
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

cli::ExitStatus status_of(std::span<const GoldenResult> results) {
    cli::ExitStatus status = cli::ExitStatus::done;
    for (const GoldenResult& result : results) {
        if (result.verdict == GoldenVerdict::failed) return cli::ExitStatus::partial;
        if (!result.is_well()) status = cli::ExitStatus::differs;
    }
    return status;
}

class Golden final : public Command {
  public:
    void add_options(options::CommandLine& line) override {
        line.arguments(names_, "DIR [NAME...]",
                       "the folder of golden.toml and of the golden pictures; only the pictures of these names");
        const options::AddOptions add(line, options::Group::comparison);
        add(golden_text::bless, run_.bless);
        add(golden_text::diffs, run_.diffs);
        const options::AddOptions add_output(line, options::Group::output);
        add_output(golden_text::junit, junit_, {.use = options::FileUse::written});
        add_output(golden_text::report, report_, {.standard_output = true, .use = options::FileUse::written});
        line.examples({{"vvr golden tests/golden --junit golden.xml", "draw all pictures again, and compare them"},
                       {"vvr golden tests/golden --bless", "replace all golden pictures"},
                       {"vvr golden tests/golden hall --diffs", "only hall.png, with a picture of the differences"}});
    }

    std::vector<std::string> also_reads() override {
        if (names_.empty())
            throw Error(ErrorCode::input_missing, "no folder given; name the folder of golden.toml: vvr golden DIR");
        run_.folder = names_.front();
        std::vector<std::string> reads;
        cases_ = read_golden_cases(run_, std::span(names_).subspan(1), reads);
        return reads;
    }

    cli::ExitStatus run(const options::CommandLine&, const cli::Environment& environment) override {
        if (!junit_.empty()) check_file_path(junit_);
        if (!report_.empty() && !is_standard_output(report_)) check_file_path(report_);
        std::vector<GoldenResult> results;
        for (const auto& one : cases_) {
            results.push_back(result_of(*one, environment));
            environment.log.info("{}: {}", one->name, name_of(results.back().verdict));
        }
        write(results, environment);
        const auto well = std::ranges::count_if(results, &GoldenResult::is_well);
        environment.log.info("'{}': {} of {} {}", run_.folder.string(), well, counted(std::ssize(results), "picture"),
                             run_.bless ? "blessed" : "as expected");
        return status_of(results);
    }

  private:
    void write(std::span<const GoldenResult> results, const cli::Environment& environment) const {
        const std::string folder = run_.folder.string();
        const auto held = environment.signals.hold();
        if (!junit_.empty()) {
            const std::string xml = junit_of(folder, results);
            replace_file(junit_, std::as_bytes(std::span(xml)));
        }
        if (report_.empty()) return;
        const std::string json = json_of(folder, results);
        if (is_standard_output(report_)) {
            cli::print(json);
        } else {
            replace_file(report_, std::as_bytes(std::span(json)));
        }
    }

    std::vector<std::string> names_;
    GoldenRun run_;
    std::vector<std::unique_ptr<GoldenCase>> cases_;
    std::filesystem::path junit_;
    std::filesystem::path report_;
};

}  // namespace

std::unique_ptr<Command> make_golden() {
    return std::make_unique<Golden>();
}

}  // namespace vvr::commands
