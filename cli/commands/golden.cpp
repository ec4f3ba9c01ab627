#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/app/render.h"
#include "cli/commands/command.h"
#include "cli/commands/render.h"
#include "cli/console.h"
#include "cli/exit_status.h"
#include "cli/options/command_line.h"
#include "cli/options/output_files.h"
#include "cli/plan/input.h"
#include "cli/plan/settings.h"
#include "core/archive/output_files.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/media/input.h"
#include "core/page/html.h"

namespace vvr::commands {

namespace {

/// The file of a folder of golden pictures that says how each is drawn.
constexpr const char* golden_list = "golden.toml";

/// How `vvr golden` treats all pictures.
struct GoldenRun {
    std::filesystem::path folder;
    bool bless = false;
    bool diffs = false;  ///< write a picture of the differences beside each golden picture
};

/// One golden picture: what is drawn, and what it is compared with.
struct GoldenCase {
    explicit GoldenCase(std::string name);

    std::string name;  ///< of its section; the picture is NAME.png in the folder
    app::RenderJob job;
    options::CommandLine line;
    std::optional<Error> fault{};  ///< why it can't be drawn
};

namespace fs = std::filesystem;
using Settings = std::vector<std::pair<std::string, std::string>>;

constexpr std::string_view input_key = "input";

Error invalid(const fs::path& list, const std::string& what) {
    return {ErrorCode::config_invalid, fmt::format("'{}': {}", list.string(), what)};
}

/// Names of files are relative to the folder of the list, so that it can be used from anywhere.
std::string in_folder(const fs::path& folder, const std::string& name) {
    return media::is_url(name) || fs::path(name).is_absolute() ? name : (folder / name).string();
}

/// A setting that names a file: the value may also be a word, such as the name of a transfer function.
std::string value_in_folder(const fs::path& folder, const options::OptionValue& option, const std::string& value) {
    const bool names_file = option.may_be_file || option.use == options::FileUse::read;
    std::error_code none;
    return names_file && fs::exists(folder / value, none) ? in_folder(folder, value) : value;
}

/// Adds what a section sets.
/// \throws Error usage for a setting that `vvr golden` itself decides
void add_settings(const options::Section& section, const fs::path& list, const options::CommandLine& line,
                  std::vector<std::string>& inputs, Settings& settings) {
    const fs::path folder = list.parent_path();
    const std::vector<options::OptionValue> known = line.values(options::all_groups);
    for (const auto& [name, values] : section.settings) {
        if (name == input_key) {
            inputs.clear();
            for (const std::string& value : values) inputs.push_back(in_folder(folder, value));
            continue;
        }
        const auto option = std::ranges::find(known, name, &options::OptionValue::name);
        const bool is_ours =
            name == "bless" || name == "golden" || (option != known.end() && option->use == options::FileUse::written);
        if (is_ours) throw invalid(list, fmt::format("it sets '{}', which `vvr golden` decides; remove it", name));
        for (const std::string& value : values) {
            settings.emplace_back(name, option == known.end() ? value : value_in_folder(folder, *option, value));
        }
    }
}

void check_name(const std::string& name, const fs::path& list) {
    if (is_plain_name(name + ".candidate.png") && name.find('.') == std::string::npos) return;
    throw invalid(list, fmt::format("the section [{}] is not usable as the name of a file; rename it", name));
}

std::unique_ptr<GoldenCase> make_case(const options::Section& general, const options::Section& own,
                                      const fs::path& list, const GoldenRun& run) {
    auto one = std::make_unique<GoldenCase>(own.name);
    std::vector<std::string> inputs;
    Settings settings;
    try {
        add_settings(general, list, one->line, inputs, settings);
        add_settings(own, list, one->line, inputs, settings);
        if (inputs.empty()) throw Error(ErrorCode::input_missing, "no input given; add: input = \"clip.avi\"");
        settings.emplace_back("golden", (run.folder / (own.name + ".png")).string());
        if (run.bless) settings.emplace_back("bless", "true");
        if (run.diffs && !run.bless) settings.emplace_back("diff", (run.folder / (own.name + ".diff.png")).string());
        one->line.take(inputs, settings);
        prepare_render(one->line, one->job);
    } catch (const Error& error) {
        if (error.code() == ErrorCode::config_invalid) throw;
        if (error.kind() == ErrorKind::usage)
            throw Error(error.code(), fmt::format("'{}', [{}]: {}", list.string(), own.name, error.what()));
        one->fault = error;
    }
    return one;
}

GoldenCase::GoldenCase(std::string section) : name(std::move(section)), line("render", "") {
    add_render_options(line, job);
}

/// Reads the folder's list. Every section is a picture; what comes before the first section holds for all of them.
/// \param wanted names of sections; empty = all
/// \param reads out: the list, and all that its pictures are drawn from or compared with
/// \throws Error usage for anything that can't be drawn as it is written; io when the list can't be read
std::vector<std::unique_ptr<GoldenCase>> read_golden_cases(const GoldenRun& run, std::span<const std::string> wanted,
                                                           std::vector<std::string>& reads) {
    const fs::path list = run.folder / golden_list;
    const std::vector<options::Section> sections = options::read_sections(list);
    std::vector<std::string> names;
    for (const options::Section& section : sections) {
        if (section.name.empty()) continue;
        check_name(section.name, list);
        names.push_back(section.name);
    }
    if (names.empty())
        throw invalid(list, "it has no pictures; add a section for each, such as [hall] with input = \"hall.avi\"");
    for (const std::string& name : wanted) {
        if (std::ranges::find(names, name) == names.end())
            throw invalid(list, fmt::format("it has no section [{}]{}", name, did_you_mean(name, names)));
    }
    std::vector<std::unique_ptr<GoldenCase>> cases;
    for (const options::Section& section : sections) {
        const bool is_wanted = wanted.empty() || std::ranges::find(wanted, section.name) != wanted.end();
        if (section.name.empty() || !is_wanted) continue;
        cases.push_back(make_case(sections.front(), section, list, run));
        std::ranges::copy(options::inputs_of(cases.back()->line), std::back_inserter(reads));
    }
    reads.push_back(list.string());
    for (const auto& one : cases) options::check_no_input_overwritten(one->line, reads);
    return cases;
}

/// What came of a golden picture.
enum class GoldenVerdict { same, blessed, differs, missing, failed };

/// The numbers of a comparison.
struct GoldenNumbers {
    double percent = 0;  ///< of the pixels that differ
    double patch = 0;    ///< largest mean difference of a patch
    double max = 0;
};

struct GoldenResult {
    std::string name;
    GoldenVerdict verdict = GoldenVerdict::same;
    std::optional<ErrorCode> code{};  ///< if it is not well
    std::string reason{};
    std::optional<GoldenNumbers> numbers{};  ///< none if nothing was compared
    double seconds = 0;

    bool is_well() const { return verdict == GoldenVerdict::same || verdict == GoldenVerdict::blessed; }
};

constexpr std::array<std::string_view, 5> verdict_names{"same", "blessed", "differs", "missing", "error"};

std::size_t count(std::span<const GoldenResult> results, bool failed) {
    return static_cast<std::size_t>(std::ranges::count_if(results, [&](const GoldenResult& result) {
        return !result.is_well() && (result.verdict == GoldenVerdict::failed) == failed;
    }));
}

double seconds_of(std::span<const GoldenResult> results) {
    double seconds = 0;
    for (const GoldenResult& result : results) seconds += result.seconds;
    return seconds;
}

/// Text of XML. Control characters and bytes that are not UTF-8 have no place in it, even escaped.
std::string xml(std::string_view text) {
    return page::html_text(shown_text(text));
}

Json rounded(double value) {
    return std::round(value * 1e6) / 1e6;
}

/// The name in reports.
std::string_view name_of(GoldenVerdict verdict) {
    return verdict_names.at(static_cast<std::size_t>(verdict));
}

/// The results as JUnit XML, as CI systems read it: a picture that differs or is missing is a failure, one that can't
/// be drawn is an error.
std::string junit_of(const std::string& folder, std::span<const GoldenResult> results) {
    const std::string counts = fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\"", results.size(),
                                           count(results, false), count(results, true), seconds_of(results));
    std::string text = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"vvr golden\" {0}>\n"
        "  <testsuite name=\"{1}\" {0} skipped=\"0\">\n",
        counts, xml(folder));
    for (const GoldenResult& result : results) {
        text += fmt::format("    <testcase name=\"{}\" classname=\"{}\" time=\"{:.3f}\"", xml(result.name), xml(folder),
                            result.seconds);
        if (result.is_well()) {
            text += "/>\n";
            continue;
        }
        const std::string_view element = result.verdict == GoldenVerdict::failed ? "error" : "failure";
        text += fmt::format(">\n      <{0} type=\"{1}\" message=\"{2}\">{2}</{0}>\n    </testcase>\n", element,
                            row_of(result.code.value_or(ErrorCode::bug)).name, xml(result.reason));
    }
    return text + "  </testsuite>\n</testsuites>\n";
}

/// The same as JSON.
std::string json_of(const std::string& folder, std::span<const GoldenResult> results) {
    Json json{{"golden", 1},
              {"vvr", version()},
              {"folder", folder},
              {"differ", count(results, false)},
              {"failed", count(results, true)},
              {"pictures", Json::array()}};
    for (const GoldenResult& result : results) {
        const auto number = [&](double GoldenNumbers::*member) {
            return result.numbers ? rounded((*result.numbers).*member) : Json();
        };
        json["pictures"].push_back({{"name", result.name},
                                    {"verdict", name_of(result.verdict)},
                                    {"code", result.code ? Json(row_of(*result.code).name) : Json()},
                                    {"reason", result.is_well() ? Json() : Json(result.reason)},
                                    {"percent_off", number(&GoldenNumbers::percent)},
                                    {"patch", number(&GoldenNumbers::patch)},
                                    {"max", number(&GoldenNumbers::max)},
                                    {"seconds", rounded(result.seconds)}});
    }
    return json_text(json, 2) + "\n";
}

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
