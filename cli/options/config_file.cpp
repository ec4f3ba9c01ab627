#include "cli/options/config_file.h"

#include <algorithm>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "cli/options/presets.h"
#include "core/base/error.h"
#include "core/base/setting.h"

namespace vvr::options {

namespace {

const CLI::Option* option_of(const CLI::App& app, const std::string& name) {
    const CLI::Option* const option = app.get_option_no_throw("--" + name);
    return option != nullptr && option->get_configurable() ? option : nullptr;
}

/// Adds the options of the config file's preset that the file does not set. The command line wins over both.
void add_preset(const CLI::App& app, std::vector<CLI::ConfigItem>& items) {
    const auto named = std::ranges::find(items, std::string(setting::preset.name), &CLI::ConfigItem::name);
    const CLI::Option* const option = option_of(app, std::string(setting::preset.name));
    if (named == items.end() || named->inputs.empty() || option == nullptr || !option->empty()) return;
    for (const auto& [name, value] : settings_of_preset(named->inputs.back())) {
        const CLI::Option* const of_preset = option_of(app, name);
        const bool is_set = std::ranges::any_of(
            items, [&](const CLI::ConfigItem& item) { return option_of(app, item.name) == of_preset; });
        if (of_preset != nullptr && !is_set) items.push_back({{}, name, {value}});
    }
}

/// The file without comments. CLI11 would take any # for a comment, even the one of a quoted colour.
std::istringstream without_comments(std::istream& input) {
    std::string text;
    for (std::string line; std::getline(input, line); text += line + '\n') {
        char quote = 0;
        char before = ' ';
        for (std::size_t i = 0; i < line.size(); before = line[i++]) {
            const bool is_quote = line[i] == '"' || line[i] == '\'';
            if (quote == 0 && line[i] == '#') {
                line.erase(i);
                break;
            }
            if (quote == 0 && is_quote && std::string_view(" \t=,[").find(before) != std::string_view::npos) {
                quote = line[i];
            } else if (line[i] == quote) {
                quote = 0;
            }
        }
    }
    return std::istringstream(text);
}

}  // namespace

std::vector<std::string> configurable_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* known : app.get_options()) {
        if (!known->get_configurable()) continue;
        const std::vector<std::string>& all = known->get_lnames();
        names.insert(names.end(), all.begin(), all.end());
    }
    return names;
}

void ConfigFile::check_section(const CLI::ConfigItem& item, const std::vector<CommandNames>& commands) const {
    if (item.parents.empty()) return;
    std::vector<std::string> names;
    for (const CommandNames& row : commands) names.push_back(row.command);
    const std::string section = fmt::format("{}", fmt::join(item.parents, "."));
    if (std::ranges::find(names, section) != names.end()) return;
    throw Error(ErrorCode::config_invalid,
                fmt::format("the config file '{}' has a section [{}], and there is no such command{}", file_, section,
                            did_you_mean(section, names)));
}

void ConfigFile::refuse(const CLI::ConfigItem& item, const std::vector<CommandNames>& commands) const {
    std::vector<std::string> names;
    for (const CommandNames& row : commands) {
        if (!item.parents.empty() && item.parents.front() != row.command) continue;
        const std::vector<std::string> options = row.options();
        if (std::ranges::find(options, item.name) != options.end()) return;
        names.insert(names.end(), options.begin(), options.end());
    }
    const std::string whose = item.parents.empty() ? std::string("which no command has")
                                                   : fmt::format("which `vvr {}` does not have", item.parents.front());
    throw Error(ErrorCode::config_invalid, fmt::format("the config file '{}' sets '{}', {}{}", file_, item.name, whose,
                                                       did_you_mean(item.name, names)));
}

std::vector<CLI::ConfigItem> ConfigFile::from_config(std::istream& input) const {
    const std::vector<CommandNames> commands = names_();
    std::vector<CLI::ConfigItem> kept;
    std::istringstream plain = without_comments(input);
    for (CLI::ConfigItem& item : CLI::ConfigTOML::from_config(plain)) {
        check_section(item, commands);
        const bool section_mark = item.name == "++" || item.name == "--";
        if (section_mark) continue;
        const bool is_for_this = item.parents.empty() || item.parents.front() == command_;
        if (!is_for_this || option_of(app_, item.name) == nullptr) {
            refuse(item, commands);
            continue;
        }
        item.parents.clear();
        kept.push_back(std::move(item));
    }
    add_preset(app_, kept);
    return kept;
}

std::vector<CLI::ConfigItem> GivenSettings::from_config(std::istream& /*input*/) const {
    std::vector<CLI::ConfigItem> taken;
    for (const auto& [name, value] : settings_) {
        const CLI::Option* const option = option_of(app_, name);
        if (option == nullptr) {
            throw Error(ErrorCode::option_unknown,
                        fmt::format("there is no setting '{}'{}", name, did_you_mean(name, configurable_names(app_))));
        }
        const std::string& known = option->get_lnames().front();
        auto item = std::ranges::find(taken, known, &CLI::ConfigItem::name);
        if (item == taken.end()) item = taken.insert(taken.end(), {{}, known, {}});
        if (option->get_multi_option_policy() != CLI::MultiOptionPolicy::TakeAll) item->inputs.clear();
        item->inputs.push_back(value);
    }
    add_preset(app_, taken);
    return taken;
}

}  // namespace vvr::options
