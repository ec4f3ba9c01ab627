#include "cli/options/command_line.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include <CLI/CLI.hpp>

#include "cli/console.h"
#include "cli/options/help.h"
#include "cli/options/presets.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/setting.h"
#include "core/base/text.h"
#include "core/video/input.h"
#include "core/video/input_files.h"
#include "core/video/recorder_names.h"
#include "core/video/recording.h"

namespace vvr::options {

namespace {

constexpr Setting camera_name_option{"camera-name", "NAME",
                                     "camera of the video, for reports, evidence and the section [camera.NAME] of the "
                                     "config file; default: from the names of files and folders"};
constexpr Setting help_option{"help", "", "print this help"};

std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

FileUse file_use(const Setting& setting, const OptionExtra& extra) {
    return setting.may_be_file ? FileUse::read : extra.use;
}

/// The option's names in CLI11's syntax.
std::string flag_of(const Setting& setting, char letter = 0) {
    return (letter == 0 ? "" : fmt::format("-{},", letter)) + fmt::format("--{}", setting.name);
}

HelpOption help_of(Group group, const Setting& setting, const std::string& shown, const OptionExtra& extra) {
    return {.group = group,
            .letter = extra.letter,
            .name = std::string(setting.name),
            .unit = std::string(setting.unit),
            .text = std::string(setting.help) + extra.help,
            .range = setting.range,
            .default_text = extra.defaults.empty() ? shown : extra.defaults,
            .values = extra.values,
            .file = file_use(setting, extra)};
}

/// Whether the arguments contain an option.
bool is_given(const CLI::Option& option, std::span<const std::string> all) {
    const std::span<const std::string> arguments(all.begin(), std::ranges::find(all, "--"));
    return std::ranges::any_of(arguments, [&](const std::string& argument) {
        return std::ranges::any_of(option.get_lnames(),
                                   [&](const std::string& name) {
                                       return argument == "--" + name || argument.starts_with("--" + name + "=");
                                   }) ||
               std::ranges::any_of(option.get_snames(),
                                   [&](const std::string& name) { return argument.starts_with("-" + name); });
    });
}

/// Calls `action`. Adds the setting to any error that it throws.
template <class Action>
void as_setting(const Setting& setting, Action action) {
    try {
        action();
    } catch (const Error& error) {
        if (!error.about().names().empty() && error.about().names().front() == setting.name) throw;
        throw Error(error.code(), fmt::format("{}: {}", setting.name, error.what()), {setting.name});
    }
}

}  // namespace

struct CommandLine::Impl {
    std::string command;
    CLI::App app;
    CommandHelp help{};
    std::vector<Setting> absent{};  ///< that a live stream can't have
    std::set<const CLI::Option*> files{};
    NamesOfCommands names_of_commands{};
    std::map<const CLI::Option*, FileUse> uses{};
    std::vector<std::string>* arguments = nullptr;
    std::map<std::string, std::function<void(const std::string&)>> plan_settings{};
    ConfigChoice config{};
    bool reads_config = true;
    bool finds_camera = false;
    std::string camera{};  ///< given
    std::string* found_camera = nullptr;
    CameraSections cameras{};
    std::vector<std::string> parsed{};

    CLI::Option* option(const Setting& setting) { return app.get_option("--" + std::string(setting.name)); }

    std::optional<OptionValue> value_of(const CLI::Option& option, std::span<const Group> groups) const {
        const bool asked =
            std::ranges::any_of(groups, [&](Group group) { return option.get_group() == title_of(group); });
        if (!asked || option.get_lnames().empty()) return std::nullopt;
        const bool all = option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
        return OptionValue{option.get_lnames().front(),
                           option.empty() ? option.get_default_str()
                           : all          ? fmt::format("{}", fmt::join(option.results(), " "))
                                          : option.results().back(),
                           files.contains(&option), uses.contains(&option) ? uses.at(&option) : FileUse::none};
    }
};

std::string OptionValue::shown() const {
    if (!may_be_file) return redact_secrets(value);
    const std::filesystem::path path(redact_secrets(value));
    return (path.has_filename() ? path : path.parent_path()).filename().string();
}

CommandLine::CommandLine(const std::string& command, const std::string& help)
    : impl_(new Impl{command, CLI::App(help)}) {
    impl_->app.name("vvr " + command);
    impl_->help.name = command;
    impl_->help.text = help;
    // Report unknown arguments in refuse_leftovers, which can suggest the nearest option.
    impl_->app.allow_extras();
}

CommandLine::~CommandLine() = default;

CommandHelp CommandLine::help() const {
    CommandHelp help = impl_->help;
    help.options.push_back(help_of(Group::run, help_option, "", {.letter = 'h'}));
    help.options.push_back(help_of(Group::run, config_option, "", {.use = FileUse::read}));
    if (impl_->finds_camera) help.options.push_back(help_of(Group::run, camera_name_option, "", {}));
    return help;
}

void CommandLine::arguments(std::vector<std::string>& target, const std::string& name, const std::string& help) {
    impl_->app.add_option("INPUT", target)->type_name("");
    impl_->arguments = &target;
    impl_->help.arguments = name;
    impl_->help.arguments_text = help;
}

std::vector<std::string> CommandLine::arguments() const {
    return impl_->arguments == nullptr ? std::vector<std::string>() : *impl_->arguments;
}

void CommandLine::examples(std::initializer_list<Example> examples) {
    impl_->help.examples = examples;
}

void CommandLine::value(Group group, const Setting& setting, const std::string& shown,
                        const std::function<void(const std::string&)>& set, const OptionExtra& extra) {
    if (for_streams_ && !setting.not_live_reason.empty()) {
        impl_->absent.push_back(setting);
        return;
    }
    CLI::Option* const option = impl_->app.add_option_function<std::string>(
        flag_of(setting, extra.letter),
        [setting, set](const std::string& given) { as_setting(setting, [&] { set(given); }); });
    option->type_name(std::string(setting.unit))->default_str(shown)->group(title_of(group))->take_last();
    if (setting.may_be_file) impl_->files.insert(option);
    const FileUse use = file_use(setting, extra);
    if (use != FileUse::none) impl_->uses.emplace(option, use);
    impl_->help.options.push_back(help_of(group, setting, shown, extra));
}

void CommandLine::flag(Group group, bool& target, const Setting& setting, const OptionExtra& extra) {
    impl_->app.add_flag(flag_of(setting, extra.letter), target)->group(title_of(group));
    impl_->help.options.push_back(help_of(group, setting, "", extra));
}

void CommandLine::list(Group group, std::vector<std::string>& target, const Setting& setting,
                       const OptionExtra& extra) {
    impl_->help.options.push_back(help_of(group, setting, "", extra));
    impl_->help.options.back().repeats = true;
    impl_->app.add_option(flag_of(setting, extra.letter), target)
        ->type_name(std::string(setting.unit))
        ->group(title_of(group))
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void CommandLine::plan_setting(const std::string& name, std::function<void(const std::string&)> set) {
    impl_->plan_settings.emplace(name, std::move(set));
}

void CommandLine::exclude(const Setting& a, const Setting& b) {
    impl_->option(a)->excludes(impl_->option(b));
}

void CommandLine::set_commands(NamesOfCommands names) {
    impl_->names_of_commands = std::move(names);
}

std::vector<std::string> CommandLine::configurable() const {
    return configurable_names(impl_->app);
}

std::vector<std::string> CommandLine::configurable(std::span<const Group> groups) const {
    std::vector<std::string> names;
    for (const OptionValue& value : values(groups)) names.push_back(value.name);
    std::erase_if(names, [known = configurable()](const std::string& name) {
        return std::ranges::find(known, name) == known.end();
    });
    return names;
}

void CommandLine::find_camera(std::string& found) {
    impl_->finds_camera = true;
    impl_->found_camera = &found;
}

void CommandLine::set_camera(const std::string& name) {
    impl_->camera = name;
}

const CameraSections& CommandLine::cameras() const {
    return impl_->cameras;
}

std::span<const std::string> CommandLine::parsed() const {
    return impl_->parsed;
}

/// The camera of all files of the input, which need not be that of an archive: it may have more folders in front. Empty
/// if they differ.
std::string CommandLine::camera_of_input(const std::vector<std::string>& patterns) const {
    const std::vector<std::string> inputs = impl_->app.get_option("INPUT")->results();
    if (inputs.empty() || inputs.front().starts_with('@') || video::is_url(inputs.front())) return {};
    std::vector<std::string> files;
    try {
        files = video::files_of_inputs(inputs);
    } catch (const Error&) {
        return {};  // opening the input reports it
    }
    // Folders in front of a recording may name the camera too.
    std::error_code none;
    const std::string& input = inputs.front();
    if (files.empty()) files.push_back(std::filesystem::is_directory(input, none) ? input + "/clip" : input);
    for (std::string& file : files) file = std::filesystem::absolute(file, none).lexically_normal().string();
    video::RecorderNames names(patterns);
    names.compare(files);
    for (const std::string& section : impl_->cameras.names) names.describe_camera(section, {});
    const std::string camera = names.camera_of(files.front());
    const bool is_one = std::ranges::all_of(files, [&](const auto& file) { return names.camera_of(file) == camera; });
    return is_one ? camera : std::string();
}

void CommandLine::refuse_unknown_camera() const {
    if (impl_->camera.empty() || !impl_->cameras.chosen.empty()) return;
    // Without sections, it only names the camera.
    if (impl_->finds_camera && impl_->cameras.names.empty()) return;
    throw Error(
        ErrorCode::option_value,
        fmt::format("camera-name: {} has no section [camera.{}]{}",
                    impl_->config.file.empty() ? "no config file is in use, so it"
                                               : fmt::format("the config file '{}'", impl_->config.file.string()),
                    impl_->camera, did_you_mean(impl_->camera, impl_->cameras.names)),
        {camera_name_option.name});
}

void CommandLine::only_find_config() {
    impl_->reads_config = false;
}

const ConfigChoice& CommandLine::config() const {
    return impl_->config;
}

bool CommandLine::parse(std::span<const std::string> arguments) {
    CLI::App& app = impl_->app;
    // Added last, so that help lists them last.
    CLI::Option* const help = app.set_help_flag("-h,--help");
    impl_->config = find_config(arguments);
    impl_->parsed.assign(arguments.begin(), arguments.end());
    if (impl_->finds_camera) {
        app.add_option(flag_of(camera_name_option), impl_->camera)
            ->type_name(std::string(camera_name_option.unit))
            ->group(title_of(Group::run))
            ->take_last()
            ->configurable(false);
    }
    const bool reads_config = impl_->reads_config && !impl_->config.is_refused();
    CLI::Option* const file = reads_config ? app.set_config(flag_of(config_option))
                                           : app.add_option(flag_of(config_option))->configurable(false);
    file->type_name(std::string(config_option.unit))->group(title_of(Group::run));
    const std::string config_name = impl_->config.file.string();
    // If the file can't be read, parsing it reports that.
    if (!config_name.empty() && reads_config) check_is_file(config_name, most_bytes::text);
    NamesOfCommands commands = impl_->names_of_commands;
    if (!commands)
        commands = [this] { return std::vector<CommandNames>{{impl_->command, [this] { return configurable(); }}}; };
    FindCamera find;
    if (impl_->finds_camera || !impl_->camera.empty()) {
        find = [this](const std::vector<std::string>& patterns) {
            const CLI::Option* const given =
                impl_->app.get_option_no_throw("--" + std::string(camera_name_option.name));
            if (given != nullptr && !given->empty()) return given->results().back();
            return impl_->camera.empty() ? camera_of_input(patterns) : impl_->camera;
        };
    }
    app.config_formatter(
        config_file_reader(app, impl_->command, config_name, std::move(commands), std::move(find), impl_->cameras));
    std::vector<std::string> reversed = with_preset(
        arguments, [&app](const std::string& name) { return app.get_option_no_throw("--" + name) != nullptr; });
    // Show help even if the config file has errors.
    const bool found = !config_name.empty() && !is_given(*file, arguments);
    if (found && reads_config && !is_given(*help, arguments)) {
        reversed.insert(reversed.begin(), "--config=" + config_name);
    }
    // CLI11 expects the arguments in reverse order.
    std::ranges::reverse(reversed);
    try {
        app.parse(std::move(reversed));
    } catch (const CLI::CallForHelp&) {
        const bool is_short = std::ranges::find(arguments, "-h") != arguments.end();
        cli::print((is_short ? short_help_text : help_text)(this->help(), help_width()));
        return false;
    } catch (const Error& error) {
        // The user may not know that a config file sets this option.
        const auto names = error.about().names();
        const CLI::Option* const wrong = names.empty() ? nullptr : app.get_option_no_throw("--" + names.front());
        if (config_name.empty() || wrong == nullptr || is_given(*wrong, arguments)) throw;
        const CameraSections& cameras = impl_->cameras;
        const bool of_camera = std::ranges::find(cameras.sets, names.front()) != cameras.sets.end();
        throw Error(error.code(),
                    fmt::format("{}; the config file '{}' sets it{}", error.what(), config_name,
                                of_camera ? fmt::format(" in [camera.{}]", cameras.chosen) : ""),
                    error.about());
    } catch (const CLI::FileError&) {
        throw Error(ErrorCode::io, fmt::format("cannot read config file '{}', {}; check the name and its permissions",
                                               config_name, impl_->config.why));
    } catch (const CLI::ParseError& error) {
        throw Error(ErrorCode::usage, fmt::format("{}; `{} --help` lists the options", error.what(), app.get_name()));
    }
    refuse_leftovers();
    refuse_two_outputs();
    refuse_unknown_camera();
    if (impl_->found_camera != nullptr) {
        *impl_->found_camera = impl_->camera.empty() ? impl_->cameras.chosen : impl_->camera;
    }
    return true;
}

void CommandLine::take(std::vector<std::string> inputs, std::span<const std::pair<std::string, std::string>> settings,
                       bool of_worker) {
    CLI::App& app = impl_->app;
    std::vector<std::pair<std::string, std::string>> of_options;
    for (const auto& [name, value] : settings) {
        const auto of_plan = impl_->plan_settings.find(name);
        if (of_worker && of_plan != impl_->plan_settings.end()) {
            of_plan->second(value);
        } else {
            of_options.emplace_back(name, value);
        }
    }
    app.config_formatter(given_settings_reader(app, of_options));
    std::istringstream nothing;
    try {
        app.parse_from_stream(nothing);
    } catch (const CLI::ParseError& error) {
        throw Error(ErrorCode::options_conflict, error.what());
    }
    if (impl_->arguments != nullptr) *impl_->arguments = std::move(inputs);
}

void CommandLine::refuse_two_outputs() const {
    for (const auto& [option, use] : impl_->uses) {
        if (use != FileUse::written && use != FileUse::filled) continue;
        const std::vector<std::string>& values = option->results();
        const auto other =
            std::ranges::find_if(values, [&](const std::string& value) { return value != values.front(); });
        if (other == values.end()) continue;
        throw Error(ErrorCode::options_conflict,
                    fmt::format("--{} is given twice, as '{}' and as '{}'; drop one of them",
                                option->get_lnames().front(), values.front(), *other));
    }
}

void CommandLine::refuse_leftovers() const {
    const CLI::App& app = impl_->app;
    std::vector<std::string> leftovers = app.remaining();
    std::erase(leftovers, "--");  // CLI11 keeps this mark for the end of the options
    if (leftovers.empty()) return;
    const auto option = std::ranges::find_if(leftovers, [](const std::string& word) { return word.starts_with('-'); });
    if (option == leftovers.end()) {
        throw Error(ErrorCode::input_unsuitable,
                    fmt::format("'{}' is one argument too many; `{} --help` lists the arguments", leftovers.front(),
                                app.get_name()));
    }
    const std::string name = option->substr(0, option->find('='));
    for (const Setting& setting : impl_->absent) {
        if (name != fmt::format("--{}", setting.name)) continue;
        throw Error(ErrorCode::option_unknown, fmt::format("{}: {}", name, setting.not_live_reason));
    }
    throw Error(ErrorCode::option_unknown, fmt::format("there is no option '{}'{}; `{} --help` lists them", name,
                                                       did_you_mean(name, option_names(app)), app.get_name()));
}

std::vector<OptionValue> CommandLine::values(std::span<const Group> groups) const {
    std::vector<OptionValue> values;
    for (const CLI::Option* option : std::as_const(impl_->app).get_options()) {
        const auto value = impl_->value_of(*option, groups);
        if (value) values.push_back(*value);
    }
    return values;
}

std::vector<OptionValue> CommandLine::given(std::span<const Group> groups) const {
    std::vector<OptionValue> given = values(groups);
    std::erase_if(given, [&](const OptionValue& value) { return impl_->app.get_option("--" + value.name)->empty(); });
    return given;
}

bool CommandLine::has(const Setting& setting) const {
    const CLI::Option* const option = impl_->app.get_option_no_throw("--" + std::string(setting.name));
    return option != nullptr && !option->empty();
}

bool CommandLine::is_argument(std::string_view name) const {
    const CLI::Option* const option = impl_->app.get_option_no_throw("--" + std::string(name));
    return option != nullptr && is_given(*option, impl_->parsed);
}

}  // namespace vvr::options
