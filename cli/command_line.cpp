#include "cli/command_line.h"

#include <algorithm>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "cli/help.h"
#include "cli/options/config_file.h"
#include "cli/options/option.h"
#include "cli/options/presets.h"
#include "cli/print.h"
#include "core/error.h"
#include "core/suggest.h"

namespace vvr {

namespace {

std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

}  // namespace

CommandLine::CommandLine(const std::string& command, const std::string& help) : command_(command), app_(help) {
    app_.name("vvr " + command);
    app_.formatter(std::make_shared<HelpText>());
    // Leftovers are refused here, where the nearest option can be named.
    app_.allow_extras();
}

bool CommandLine::parse(std::span<const std::string> arguments) {
    // Added last, so that they stand last in the help.
    app_.set_help_flag("-h,--help", "print this and end")->group(group::run);
    app_.set_config("--config", "", "a file with long option names, `size = 1280x800`; the command line wins")
        ->type_name("FILE")
        ->group(group::run);
    app_.config_formatter(std::make_shared<ConfigFile>(app_, command_));
    // CLI11 takes them from the back.
    std::vector<std::string> reversed = with_preset(arguments);
    std::ranges::reverse(reversed);
    try {
        app_.parse(std::move(reversed));
    } catch (const CLI::CallForHelp&) {
        print(app_.help());
        return false;
    } catch (const CLI::FileError& error) {
        throw Error(ErrorKind::io, fmt::format("cannot read config file '{}'; check the name and its permissions",
                                               app_.get_config_ptr()->as<std::string>()));
    } catch (const CLI::ParseError& error) {
        throw Error(ErrorKind::usage, fmt::format("{}; `{} --help` lists the options", error.what(), app_.get_name()));
    }
    refuse_leftovers();
    return true;
}

void CommandLine::refuse_leftovers() const {
    const std::vector<std::string> leftovers = app_.remaining();
    if (leftovers.empty()) return;
    const auto option = std::ranges::find_if(leftovers, [](const std::string& word) { return word.starts_with('-'); });
    if (option == leftovers.end()) {
        throw Error(ErrorKind::usage, fmt::format("'{}' is one argument too many; `{} --help` says what it takes",
                                                  leftovers.front(), app_.get_name()));
    }
    const std::string name = option->substr(0, option->find('='));
    throw Error(ErrorKind::usage, fmt::format("there is no option '{}'{}; `{} --help` lists them", name,
                                              did_you_mean(name, option_names(app_)), app_.get_name()));
}

std::vector<std::string> CommandLine::names(std::initializer_list<const char*> groups) const {
    std::vector<std::string> names;
    for (const CLI::Option* option : app_.get_options()) {
        const bool asked = std::ranges::find(groups, option->get_group()) != groups.end();
        if (asked && !option->get_lnames().empty()) names.push_back(option->get_lnames().front());
    }
    return names;
}

std::optional<std::string> CommandLine::given(const std::string& option) const {
    const CLI::Option* const found = app_.get_option_no_throw("--" + option);
    return found == nullptr || found->empty() ? std::nullopt : std::optional(found->results().back());
}

Metadata CommandLine::settings(const std::string& group, const Metadata& decided) const {
    Metadata settings;
    for (const CLI::Option* option : app_.get_options()) {
        if (option->get_group() != group || option->get_lnames().empty()) continue;
        const std::string& name = option->get_lnames().front();
        const auto elsewhere = std::ranges::find(decided, name, &Metadata::value_type::first);
        std::string value = option->empty() ? option->get_default_str() : option->results().back();
        if (elsewhere != decided.end()) value = elsewhere->second;
        if (!value.empty()) settings.emplace_back(name, value);
    }
    return settings;
}

}  // namespace vvr
