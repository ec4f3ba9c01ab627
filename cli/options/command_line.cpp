#include "cli/options/command_line.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/console.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/footage/recorder_names.h"

namespace vvr::options {

namespace {

constexpr Setting camera_name_option{"camera-name", "NAME",
                                     "camera of the video, for reports, evidence and the section [camera.NAME] of the "
                                     "config file; default: from the names of files and folders"};
constexpr Setting help_option{"help", "", "print this help"};

/// \returns null if the command does not have it
template <class Options>
auto* find_in(Options& options, std::string_view name) {
    const auto found = std::ranges::find_if(
        options, [&](const Option& option) { return option.help.name == name && option.is_visible(); });
    return found == options.end() ? nullptr : &*found;
}

bool is_in(const Option& option, std::span<const Group> groups) {
    return std::ranges::find(groups, option.help.group) != groups.end();
}

/// Calls `action`. Adds the option to any error that it throws.
template <class Action>
void as_option(const Option& option, const Action& action) {
    const std::string& name = option.help.name;
    try {
        action();
    } catch (const Error& error) {
        if (!error.about().names().empty() && error.about().names().front() == name) throw;
        throw Error(error.code(), fmt::format("{}: {}", name, error.what()), {name});
    }
}

void set_variable(const Option& option) {
    if (option.refuses_dash && option.given.back() == "-") {
        throw Error(ErrorCode::option_value,
                    "'-' means standard input or output, which is not possible here; write ./- for a file of that "
                    "name");
    }
    const bool all = option.value.shape == Value::Shape::list;
    for (const std::string& text : all ? std::span(option.given) : std::span(option.given).last(1))
        option.value.set(text);
}

}  // namespace

std::string OptionValue::shown() const {
    if (!may_be_file) return redact_secrets(value);
    const std::filesystem::path path(redact_secrets(value));
    return (path.has_filename() ? path : path.parent_path()).filename().string();
}

void Option::give(std::span<const std::string> texts, Source by) {
    if (texts.empty() || by < source) return;
    if (by > source) given.clear();
    source = by;
    given.insert(given.end(), texts.begin(), texts.end());
}

OptionValue Option::as_text() const {
    const std::string text = !is_given()                         ? default_value
                             : value.shape == Value::Shape::list ? fmt::format("{}", fmt::join(given, " "))
                                                                 : given.back();
    return {help.name, text, may_be_file, help.file, source};
}

CommandLine::CommandLine(std::string command, std::string help)
    : help_{.name = std::move(command),
            .text = std::move(help),
            .arguments = {},
            .arguments_text = {},
            .options = {},
            .examples = {}} {}

CommandHelp CommandLine::help() const {
    CommandHelp help = help_;
    for (const Option& option : options_) {
        if (option.is_visible()) help.options.push_back(option.help);
    }
    return help;
}

void CommandLine::arguments(std::vector<std::string>& target, const std::string& name, const std::string& help) {
    arguments_ = &target;
    help_.arguments = name;
    help_.arguments_text = help;
}

std::vector<std::string> CommandLine::arguments() const {
    return arguments_ == nullptr ? std::vector<std::string>() : *arguments_;
}

void CommandLine::add(Group group, const Setting& setting, Value value, const OptionExtra& extra) {
    const bool has_default = value.shape == Value::Shape::one;
    Option option{.help = {.group = group,
                           .letter = extra.letter,
                           .name = std::string(setting.name),
                           .unit = std::string(setting.unit),
                           .text = std::string(setting.help) + value.help + extra.help,
                           .range = setting.range,
                           .default_text = {},
                           .values = value.choices,
                           .file = setting.may_be_file ? FileUse::read : extra.use,
                           .repeats = value.shape == Value::Shape::list},
                  .value = std::move(value),
                  .default_value = {},
                  .may_be_file = setting.may_be_file};
    if (has_default)
        option.default_value = setting.default_text.empty() ? option.value.text() : std::string(setting.default_text);
    option.help.default_text = option.value.defaults.empty() ? option.default_value : option.value.defaults;
    const bool is_output = extra.letter == 'o' || extra.use != FileUse::none;
    option.refuses_dash = option.value.is_path && is_output && !extra.standard_output;
    if (for_streams_) option.not_live_reason = setting.not_live_reason;
    options_.push_back(std::move(option));
}

void CommandLine::after(const Setting& setting, const std::function<void()>& action) {
    Option* const option = find_in(options_, setting.name);
    if (option == nullptr) return;
    option->value.set = [set = option->value.set, action](const std::string& text) {
        set(text);
        action();
    };
}

void CommandLine::add_common(NamesOfCommands names) {
    names_of_commands_ = std::move(names);
    const auto nothing = [](const std::string&) {};
    const auto none = [] { return std::string(); };
    add(Group::run, help_option, {nothing, none, Value::Shape::flag}, {.letter = 'h'});
    add(Group::run, config_option, {nothing, none}, {.use = FileUse::read});
    if (found_camera_ != nullptr) add(Group::run, camera_name_option, value_of(camera_name_option, camera_));
    for (const Setting& setting : {help_option, config_option, camera_name_option}) {
        if (Option* const option = find_in(options_, setting.name)) option->is_configurable = false;
    }
}

std::vector<std::string> CommandLine::configurable(std::span<const Group> groups) const {
    std::vector<std::string> names;
    for (const Option& option : options_) {
        if (is_in(option, groups) && option.is_visible() && option.is_configurable) names.push_back(option.help.name);
    }
    return names;
}

bool CommandLine::parse(std::span<const std::string> arguments) {
    const std::vector<std::string> unknown = read_arguments(arguments);
    if (has(help_option)) {
        const bool is_short = std::ranges::find(arguments, "-h") != arguments.end();
        cli::print((is_short ? short_help_text : help_text)(help(), help_width()));
        return false;
    }
    refuse(unknown);
    const Option* const file = find_in(options_, config_option.name);
    config_ = find_config(file->is_given() ? std::optional(file->given.back()) : std::nullopt);
    if (reads_config_ && !config_.file.empty()) sections_ = read_config(config_, names_of_commands_());
    give_config();
    return true;
}

void CommandLine::parse_for_camera(const CommandLine& parsed, const std::string& camera) {
    inputs_ = parsed.inputs_;
    config_ = parsed.config_;
    sections_ = parsed.sections_;
    camera_ = camera;
    for (const Option& option : parsed.options_) {
        if (option.source != Source::argument || option.help.name == camera_name_option.name) continue;
        if (Option* const own = find_in(options_, option.help.name)) own->give(option.given, Source::argument);
    }
    give_config();
}

void CommandLine::give(const Section& section, Source source) {
    for (const auto& [name, values] : section.settings) {
        Option* const option = find_in(options_, name);
        if (option != nullptr && option->is_configurable) option->give(values, source);
    }
}

/// Gives what the config file and a preset set, then sets all variables.
void CommandLine::give_config() {
    try {
        for (const Section& section : sections_) {
            if (section.name.empty()) give(section, Source::config);
            if (section.name == help_.name) give(section, Source::section);
        }
        give_camera();
        give_preset();
        set_variables();
    } catch (const Error& error) {
        // The user may not know that a config file sets this option.
        const auto names = error.about().names();
        const Option* const wrong = names.empty() ? nullptr : find_in(options_, names.front());
        if (wrong == nullptr || !is_config(wrong->source)) throw;
        throw Error(error.code(),
                    fmt::format("{}; the config file '{}' sets it{}", error.what(), config_.file.string(),
                                wrong->source == Source::camera ? fmt::format(" in [camera.{}]", section_) : ""),
                    error.about());
    }
    refuse_two_outputs();
    check_camera();
}

void CommandLine::give_camera() {
    if (found_camera_ != nullptr && has(camera_name_option))
        camera_ = find_in(options_, camera_name_option.name)->given.back();
    const std::vector<std::string> known = cameras();
    if (!known.empty() && (found_camera_ != nullptr || !camera_.empty())) {
        const Option* const patterns = find_in(options_, setting::names.name);
        section_ = footage::name_of_camera(
            !camera_.empty() ? camera_
                             : camera_of_input(inputs_, patterns == nullptr ? inputs_ : patterns->given, known),
            known);
    }
    for (const Section& section : sections_) {
        if (!section_.empty() && camera_of(section) == section_) give(section, Source::camera);
    }
    if (found_camera_ != nullptr) *found_camera_ = camera_.empty() ? section_ : camera_;
}

void CommandLine::check_camera() const {
    const std::vector<std::string> known = cameras();
    // Without sections, it only names the camera.
    if (camera_.empty() || !section_.empty() || (found_camera_ != nullptr && known.empty())) return;
    throw Error(ErrorCode::option_value,
                fmt::format("camera-name: {} has no section [camera.{}]{}",
                            config_.file.empty() ? "no config file is in use, so it"
                                                 : fmt::format("the config file '{}'", config_.file.string()),
                            camera_, did_you_mean(camera_, known)),
                {camera_name_option.name});
}

/// The options of the preset take the place of those with less precedence than the preset itself.
void CommandLine::give_preset() {
    const Option* const preset = find_in(options_, setting::preset.name);
    if (preset == nullptr || !preset->is_given()) return;
    const Source source = preset->source == Source::argument ? Source::preset
                          : preset->source == Source::camera ? Source::camera
                                                             : Source::config;
    for (const auto& [name, value] : settings_of_preset(preset->given.back())) {
        Option* const option = find_in(options_, name);
        if (option != nullptr && option->source < source) option->give(std::array{std::string(value)}, source);
    }
}

void CommandLine::set_variables() {
    for (const auto& [a, b] : excluded_) {
        if (!has(a) || !has(b)) continue;
        throw Error(ErrorCode::usage,
                    fmt::format("--{} excludes --{}; `vvr {} --help` lists the options", a, b, help_.name));
    }
    for (const Option& option : options_) {
        if (option.is_given()) as_option(option, [&] { set_variable(option); });
    }
    if (arguments_ != nullptr) *arguments_ = inputs_;
}

void CommandLine::take(std::vector<std::string> inputs, std::span<const std::pair<std::string, std::string>> settings,
                       bool of_worker) {
    inputs_ = std::move(inputs);
    for (const auto& [name, value] : settings) {
        const auto option = std::ranges::find_if(options_, [&, &known = name](const Option& one) {
            const bool is_possible = one.is_visible() || (of_worker && one.help.group == Group::plan);
            return one.help.name == known && is_possible && one.is_configurable;
        });
        if (option == options_.end()) {
            throw Error(ErrorCode::option_unknown,
                        fmt::format("there is no setting '{}'{}", name, did_you_mean(name, configurable())));
        }
        option->give(std::array{value}, Source::argument);
    }
    give_preset();
    set_variables();
}

void CommandLine::refuse_two_outputs() const {
    for (const Option& option : options_) {
        if (option.help.file != FileUse::written && option.help.file != FileUse::filled) continue;
        const auto other =
            std::ranges::find_if(option.given, [&](const std::string& value) { return value != option.given.front(); });
        if (other == option.given.end()) continue;
        throw Error(ErrorCode::options_conflict,
                    fmt::format("--{} is given twice, as '{}' and as '{}'; drop one of them", option.help.name,
                                option.given.front(), *other));
    }
}

std::vector<OptionValue> CommandLine::values(std::span<const Group> groups) const {
    std::vector<OptionValue> values;
    for (const Option& option : options_) {
        if (is_in(option, groups) && option.is_visible()) values.push_back(option.as_text());
    }
    return values;
}

std::vector<OptionValue> CommandLine::given(std::span<const Group> groups) const {
    std::vector<OptionValue> given = values(groups);
    std::erase_if(given, [&](const OptionValue& value) { return value.source == Source::none; });
    return given;
}

image::Metadata CommandLine::record(std::span<const Group> groups) const {
    image::Metadata record;
    for (const Option& option : options_) {
        // A command for streams may have another option in place of one.
        if (!is_in(option, groups) || find_in(options_, option.help.name) == nullptr) continue;
        OptionValue text = option.as_text();
        text.value = option.value.text();
        image::put(record, text.name, text.shown());
    }
    return record;
}

bool CommandLine::has(std::string_view name) const {
    const Option* const option = find_in(options_, name);
    return option != nullptr && option->is_given();
}

bool CommandLine::is_argument(std::string_view name) const {
    const Option* const option = find_in(options_, name);
    return option != nullptr && option->source == Source::argument;
}

}  // namespace vvr::options
