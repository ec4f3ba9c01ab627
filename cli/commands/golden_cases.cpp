#include "cli/commands/golden_cases.h"

#include <algorithm>
#include <iterator>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands/render.h"
#include "cli/exit_status.h"
#include "cli/options/output_files.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/media/input.h"

namespace vvr::commands {

namespace {

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

}  // namespace

GoldenCase::GoldenCase(std::string section) : name(std::move(section)), line("render", "") {
    add_render_options(line, job);
}

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

}  // namespace vvr::commands
