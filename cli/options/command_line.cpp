#include "cli/options/command_line.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <type_traits>

#include <CLI/CLI.hpp>

#include "cli/options/config_file.h"
#include "cli/options/help.h"
#include "cli/options/parse_value.h"
#include "cli/options/presets.h"
#include "cli/print.h"
#include "core/error.h"
#include "core/suggest.h"

namespace vvr {

namespace {

constexpr Setting config_option{"config", "FILE",
                                "read long option names and values, as `size = 1280x800`; the command line wins"};
constexpr Setting no_config_option{"no-config", "", "read no config file, wherever one is"};

template <class T>
struct Unwrapped {
    using Type = T;
};
template <class T>
struct Unwrapped<std::optional<T>> {
    using Type = T;
};

std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

std::string flag_of(const Setting& setting, char letter) {
    return (letter == 0 ? "" : fmt::format("-{},", letter)) + fmt::format("--{}", setting.name);
}

/// Whether an option stands among the arguments.
bool is_given(const CLI::Option& option, std::span<const std::string> arguments) {
    return std::ranges::any_of(arguments, [&](const std::string& argument) {
        return std::ranges::any_of(option.get_lnames(),
                                   [&](const std::string& name) {
                                       return argument == "--" + name || argument.starts_with("--" + name + "=");
                                   }) ||
               std::ranges::any_of(option.get_snames(),
                                   [&](const std::string& name) { return argument.starts_with("-" + name); });
    });
}

/// Calls `action`; whatever is wrong is about the setting.
template <class Action>
void as_setting(const Setting& setting, Action action) {
    try {
        action();
    } catch (const Error& error) {
        if (!error.about().names().empty() && error.about().names().front() == setting.name) throw;
        throw Error(error.kind(), fmt::format("{}: {}", setting.name, error.what()), {setting.name});
    }
}

}  // namespace

struct CommandLine::Impl {
    std::string command;
    CLI::App app;
    HelpText::Ranges ranges{};
    std::map<const CLI::Option*, bool> files{};
    ConfigChoice config{};
    bool reads_config = true;

    CLI::Option* option(const Setting& setting) { return app.get_option("--" + std::string(setting.name)); }

    std::optional<OptionValue> value_of(const CLI::Option& option, std::initializer_list<Group> groups) const {
        const bool asked =
            std::ranges::any_of(groups, [&](Group group) { return option.get_group() == title_of(group); });
        if (!asked || option.get_lnames().empty()) return std::nullopt;
        const bool all = option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
        return OptionValue{option.get_lnames().front(),
                           option.empty() ? option.get_default_str()
                           : all          ? fmt::format("{}", fmt::join(option.results(), " "))
                                          : option.results().back(),
                           files.contains(&option)};
    }
};

std::string OptionValue::shown() const {
    if (!may_be_file) return value;
    const std::filesystem::path path(value);
    return (path.has_filename() ? path : path.parent_path()).filename().string();
}

CommandLine::CommandLine(const std::string& command, const std::string& help)
    : impl_(new Impl{command, CLI::App(help)}) {
    impl_->app.name("vvr " + command);
    impl_->app.formatter(std::make_shared<HelpText>(impl_->ranges));
    // Leftovers are refused here, where the nearest option can be named.
    impl_->app.allow_extras();
}

CommandLine::~CommandLine() = default;

void CommandLine::arguments(std::vector<std::string>& target, const std::string& name, const std::string& help) {
    impl_->app.add_option(name, target, help)->type_name("");
}

void CommandLine::value(Group group, const Setting& setting, const std::string& shown,
                        const std::function<void(const std::string&)>& set, const OptionExtra& extra) {
    CLI::Option* const option = impl_->app.add_option_function<std::string>(
        flag_of(setting, extra.letter),
        [setting, set](const std::string& given) { as_setting(setting, [&] { set(given); }); },
        std::string(setting.help) + extra.help);
    option->type_name(std::string(setting.unit))->default_str(shown)->group(title_of(group))->take_last();
    if (setting.may_be_file) impl_->files.emplace(option, true);
    if (setting.range.low < setting.range.high) {
        impl_->ranges.emplace(option, fmt::format("{}..{}", setting.range.low, setting.range.high));
    }
}

template <class Number>
void CommandLine::number(Group group, Number& target, const Setting& setting, const OptionExtra& extra) {
    using Value = typename Unwrapped<Number>::Type;
    std::string shown(setting.otherwise);
    if constexpr (std::is_same_v<Number, Value>) {
        if (shown.empty()) shown = fmt::format("{}", target);
    }
    const auto set = [&target, range = setting.range](const std::string& given) {
        if constexpr (std::is_integral_v<Value>) {
            target = static_cast<Value>(
                parse_integer(given, static_cast<std::int64_t>(range.low), static_cast<std::int64_t>(range.high)));
        } else {
            target = parse_number(given, range);
        }
    };
    value(group, setting, shown, set, extra);
}

template void CommandLine::number(Group, double&, const Setting&, const OptionExtra&);
template void CommandLine::number(Group, int&, const Setting&, const OptionExtra&);
template void CommandLine::number(Group, std::int64_t&, const Setting&, const OptionExtra&);
template void CommandLine::number(Group, std::optional<double>&, const Setting&, const OptionExtra&);
template void CommandLine::number(Group, std::optional<int>&, const Setting&, const OptionExtra&);

void CommandLine::text(Group group, std::string& target, const Setting& setting, const OptionExtra& extra) {
    value(
        group, setting, target, [&target](const std::string& given) { target = given; }, extra);
}

void CommandLine::path(Group group, std::filesystem::path& target, const Setting& setting, const OptionExtra& extra) {
    value(
        group, setting, target.string(), [&target](const std::string& given) { target = given; }, extra);
}

void CommandLine::flag(Group group, bool& target, const Setting& setting, const OptionExtra& extra) {
    impl_->app.add_flag(flag_of(setting, extra.letter), target, std::string(setting.help) + extra.help)
        ->group(title_of(group));
}

void CommandLine::list(Group group, std::vector<std::string>& target, const Setting& setting,
                       const OptionExtra& extra) {
    impl_->app.add_option(flag_of(setting, extra.letter), target, std::string(setting.help) + extra.help)
        ->type_name(std::string(setting.unit))
        ->group(title_of(group))
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void CommandLine::name(Group group, std::string& target, const std::vector<std::string>& names,
                       const Setting& setting) {
    value(group, setting, target,
          [&target, names, name = setting.name](const std::string& given) {
              if (std::ranges::count(names, given) == 0) refuse_choice(name, given, names);
              target = given;
          },
          {.help = fmt::format(": {}", fmt::join(names, ", "))});
}

void CommandLine::add_footer(const std::string& text) {
    impl_->app.footer(impl_->app.get_footer() + text);
}

void CommandLine::exclude(const Setting& a, const Setting& b) {
    impl_->option(a)->excludes(impl_->option(b));
}

void CommandLine::only_find_config() {
    impl_->reads_config = false;
}

const ConfigChoice& CommandLine::config() const {
    return impl_->config;
}

bool CommandLine::parse(std::span<const std::string> arguments) {
    CLI::App& app = impl_->app;
    // Added last, so that they stand last in the help.
    CLI::Option* const help = app.set_help_flag("-h,--help", "print this and end");
    help->group(title_of(Group::run));
    CLI::Option* const file = impl_->reads_config
                                  ? app.set_config(flag_of(config_option, 0), "", std::string(config_option.help))
                                  : app.add_option(flag_of(config_option, 0))
                                        ->description(std::string(config_option.help))
                                        ->configurable(false);
    file->type_name(std::string(config_option.unit))->group(title_of(Group::run));
    app.add_flag(flag_of(no_config_option, 0))
        ->description(std::string(no_config_option.help))
        ->configurable(false)
        ->excludes(file)
        ->group(title_of(Group::run));
    impl_->config = find_config(arguments);
    const std::string config_name = impl_->config.file.string();
    app.config_formatter(std::make_shared<ConfigFile>(app, impl_->command, config_name));
    std::vector<std::string> reversed = with_preset(arguments);
    // Help is there for whoever wants to mend a config file too.
    const bool found = !config_name.empty() && !is_given(*file, arguments);
    if (found && impl_->reads_config && !is_given(*help, arguments)) {
        reversed.insert(reversed.begin(), "--config=" + config_name);
    }
    // CLI11 takes them from the back.
    std::ranges::reverse(reversed);
    try {
        app.parse(std::move(reversed));
    } catch (const CLI::CallForHelp&) {
        print(app.help());
        return false;
    } catch (const Error& error) {
        // Whoever reads this may not know of the config file, nor that it sets the option.
        const auto names = error.about().names();
        const CLI::Option* const wrong = names.empty() ? nullptr : app.get_option_no_throw("--" + names.front());
        if (config_name.empty() || wrong == nullptr || is_given(*wrong, arguments)) throw;
        throw Error(error.kind(), fmt::format("{}; the config file '{}' sets it", error.what(), config_name),
                    error.about());
    } catch (const CLI::FileError&) {
        throw Error(ErrorKind::io, fmt::format("cannot read config file '{}', {}; check the name and its permissions",
                                               config_name, impl_->config.why));
    } catch (const CLI::ParseError& error) {
        throw Error(ErrorKind::usage, fmt::format("{}; `{} --help` lists the options", error.what(), app.get_name()));
    }
    refuse_leftovers();
    return true;
}

void CommandLine::refuse_leftovers() const {
    const CLI::App& app = impl_->app;
    const std::vector<std::string> leftovers = app.remaining();
    if (leftovers.empty()) return;
    const auto option = std::ranges::find_if(leftovers, [](const std::string& word) { return word.starts_with('-'); });
    if (option == leftovers.end()) {
        throw Error(ErrorKind::usage, fmt::format("'{}' is one argument too many; `{} --help` lists what it takes",
                                                  leftovers.front(), app.get_name()));
    }
    const std::string name = option->substr(0, option->find('='));
    throw Error(ErrorKind::usage, fmt::format("there is no option '{}'{}; `{} --help` lists them", name,
                                              did_you_mean(name, option_names(app)), app.get_name()));
}

std::vector<OptionValue> CommandLine::values(std::initializer_list<Group> groups) const {
    std::vector<OptionValue> values;
    for (const CLI::Option* option : std::as_const(impl_->app).get_options()) {
        const auto value = impl_->value_of(*option, groups);
        if (value) values.push_back(*value);
    }
    return values;
}

std::vector<OptionValue> CommandLine::given(std::initializer_list<Group> groups) const {
    std::vector<OptionValue> values;
    for (const CLI::Option* option : std::as_const(impl_->app).get_options()) {
        if (const auto value = impl_->value_of(*option, groups); value && !option->empty()) values.push_back(*value);
    }
    return values;
}

bool CommandLine::has(const Setting& setting) const {
    return !impl_->option(setting)->empty();
}

}  // namespace vvr
