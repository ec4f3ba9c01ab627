#include "cli/options/config_file.h"

#include <algorithm>
#include <cstdlib>
#include <istream>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/options/presets.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/setting.h"
#include "core/video/recorder_names.h"

namespace vvr::options {

namespace {

constexpr std::string_view no_config = "none";
constexpr std::string_view camera_section = "camera";

/// Whether CLI11 marks the beginning or the end of a section with it.
bool is_mark(const CLI::ConfigItem& item) {
    return item.name == "++" || item.name == "--";
}

/// The last one wins, as with every option.
std::optional<std::string> given_file(std::span<const std::string> arguments) {
    std::optional<std::string> file;
    const auto config_flag = fmt::format("--{}", config_option.name);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string_view argument = arguments[i];
        if (argument == "--") break;
        if (argument == config_flag && i + 1 < arguments.size()) file = arguments[i + 1];
        if (argument.starts_with(config_flag) && argument.substr(config_flag.size()).starts_with('=')) {
            file = argument.substr(config_flag.size() + 1);
        }
    }
    return file;
}

std::vector<std::filesystem::path> usual_places() {
    std::vector<std::filesystem::path> places;
    const char* const config_home = std::getenv("XDG_CONFIG_HOME");
    const char* const home = std::getenv("HOME");
    // The XDG Base Directory Specification says to ignore relative paths.
    if (config_home != nullptr && std::filesystem::path(config_home).is_absolute()) {
        places.push_back(std::filesystem::path(config_home) / "vvr/vvr.toml");
    } else if (home != nullptr && std::filesystem::path(home).is_absolute()) {
        places.push_back(std::filesystem::path(home) / ".config/vvr/vvr.toml");
    }
    places.emplace_back("/etc/vvr/vvr.toml");
    return places;
}

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

class ConfigFile : public CLI::ConfigTOML {
  public:
    ConfigFile(const CLI::App& app, std::string command, std::string file, NamesOfCommands names,
               FindCamera find_camera, CameraSections& cameras)
        : app_(app),
          command_(std::move(command)),
          file_(std::move(file)),
          names_(std::move(names)),
          find_camera_(std::move(find_camera)),
          cameras_(cameras) {
        comment('\0');  // removed before CLI11 parses the file
    }

    std::vector<CLI::ConfigItem> from_config(std::istream& input) const override;

  private:
    void check_section(const CLI::ConfigItem& item, const std::vector<CommandNames>& commands) const;
    void refuse(const CLI::ConfigItem& item, const std::vector<CommandNames>& commands) const;
    void refuse_for_camera(const CLI::ConfigItem& item, const std::vector<CommandNames>& commands) const;
    void apply_camera(std::vector<CLI::ConfigItem>& general, const std::vector<CLI::ConfigItem>& of_cameras) const;

    const CLI::App& app_;
    std::string command_;
    std::string file_;  ///< for error texts
    NamesOfCommands names_;
    FindCamera find_camera_;
    CameraSections& cameras_;
};

class GivenSettings : public CLI::ConfigTOML {
  public:
    GivenSettings(const CLI::App& app, std::span<const std::pair<std::string, std::string>> settings)
        : app_(app), settings_(settings) {}

    std::vector<CLI::ConfigItem> from_config(std::istream& input) const override;

  private:
    const CLI::App& app_;
    std::span<const std::pair<std::string, std::string>> settings_;
};

/// The name of a section, which may have quotes.
std::string unquoted(const std::string& name) {
    const bool is_quoted =
        name.size() > 2 && name.front() == name.back() && (name.front() == '"' || name.front() == '\'');
    return is_quoted ? name.substr(1, name.size() - 2) : name;
}

/// The camera of a section [camera.NAME]; a name may have quotes and dots. Empty for other sections.
std::string camera_of(const CLI::ConfigItem& item) {
    if (item.parents.size() < 2 || item.parents.front() != camera_section) return {};
    return unquoted(fmt::format("{}", fmt::join(item.parents.begin() + 1, item.parents.end(), ".")));
}

void ConfigFile::check_section(const CLI::ConfigItem& item, const std::vector<CommandNames>& commands) const {
    if (item.parents.empty() || !camera_of(item).empty()) return;
    if (item.parents.front() == camera_section) {
        if (is_mark(item)) return;
        throw Error(ErrorCode::config_invalid,
                    fmt::format("the config file '{}' has a section [camera] without the name of a camera; write "
                                "[camera.NAME]",
                                file_));
    }
    std::vector<std::string> names;
    for (const CommandNames& row : commands) names.push_back(row.command);
    const std::string section = fmt::format("{}", fmt::join(item.parents, "."));
    if (std::ranges::find(names, section) != names.end()) return;
    throw Error(ErrorCode::config_invalid,
                fmt::format("the config file '{}' has a section [{}], but there is no such command{}", file_, section,
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

void ConfigFile::refuse_for_camera(const CLI::ConfigItem& item, const std::vector<CommandNames>& commands) const {
    std::vector<std::string> names;
    for (const CommandNames& row : commands) {
        if (!row.camera_options) continue;
        const std::vector<std::string> options = row.camera_options();
        if (std::ranges::find(options, item.name) != options.end()) return;
        names.insert(names.end(), options.begin(), options.end());
    }
    throw Error(
        ErrorCode::config_invalid,
        fmt::format("the config file '{}' sets '{}' in [camera.{}], which is not an option for the videos of one "
                    "camera{}",
                    file_, item.name, camera_of(item), did_you_mean(item.name, names)));
}

std::vector<CLI::ConfigItem> ConfigFile::from_config(std::istream& input) const {
    const std::vector<CommandNames> commands = names_();
    std::vector<CLI::ConfigItem> kept;
    std::vector<CLI::ConfigItem> of_cameras;
    std::istringstream plain = without_comments(input);
    for (CLI::ConfigItem& item : CLI::ConfigTOML::from_config(plain)) {
        check_section(item, commands);
        if (const std::string camera = camera_of(item); !camera.empty()) {
            if (std::ranges::find(cameras_.names, camera) == cameras_.names.end()) cameras_.names.push_back(camera);
            if (is_mark(item)) continue;
            refuse_for_camera(item, commands);
            of_cameras.push_back(std::move(item));
            continue;
        }
        if (is_mark(item)) continue;
        const bool is_for_this = item.parents.empty() || item.parents.front() == command_;
        if (!is_for_this || option_of(app_, item.name) == nullptr) {
            refuse(item, commands);
            continue;
        }
        item.parents.clear();
        kept.push_back(std::move(item));
    }
    apply_camera(kept, of_cameras);
    add_preset(app_, kept);
    return kept;
}

/// Replaces settings by those of the camera's section.
void ConfigFile::apply_camera(std::vector<CLI::ConfigItem>& general,
                              const std::vector<CLI::ConfigItem>& of_cameras) const {
    if (!find_camera_ || cameras_.names.empty()) return;
    std::vector<std::string> patterns;
    if (const CLI::Option* const names = option_of(app_, "names")) {
        patterns = names->results();
        for (const CLI::ConfigItem& item : general) {
            if (names->empty() && item.name == "names")
                patterns.insert(patterns.end(), item.inputs.begin(), item.inputs.end());
        }
    }
    cameras_.chosen = video::name_of_camera(find_camera_(patterns), cameras_.names);
    if (cameras_.chosen.empty()) return;
    std::vector<CLI::ConfigItem> own;
    for (const CLI::ConfigItem& item : of_cameras) {
        if (camera_of(item) == cameras_.chosen && option_of(app_, item.name) != nullptr)
            own.push_back({{}, item.name, item.inputs});
    }
    add_preset(app_, own);
    for (const CLI::ConfigItem& item : own) {
        cameras_.sets.push_back(option_of(app_, item.name)->get_lnames().front());
        std::erase_if(general, [&](const CLI::ConfigItem& other) {
            return option_of(app_, other.name) == option_of(app_, item.name);
        });
    }
    general.insert(general.end(), own.begin(), own.end());
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

}  // namespace

std::vector<Section> read_sections(const std::filesystem::path& file) {
    std::istringstream text(read_file(file.string(), most_bytes::text));
    CLI::ConfigTOML format;
    format.comment('\0');
    std::vector<Section> sections;
    const auto section = [&](const std::vector<std::string>& parents) -> Section& {
        const std::string name = unquoted(fmt::format("{}", fmt::join(parents, ".")));
        const auto known = std::ranges::find(sections, name, &Section::name);
        return known == sections.end() ? sections.emplace_back(Section{name}) : *known;
    };
    try {
        std::istringstream plain = without_comments(text);
        for (const CLI::ConfigItem& item : format.from_config(plain)) {
            // Marks have no values.
            Section& in = section(item.parents);
            if (!is_mark(item)) in.settings.emplace_back(item.name, item.inputs);
        }
    } catch (const CLI::Error& error) {
        throw Error(ErrorCode::config_invalid, fmt::format("cannot read '{}': {}; write lines such as `size = 320x200`",
                                                           file.string(), error.what()));
    }
    return sections;
}

ConfigChoice find_config(std::span<const std::string> arguments) {
    if (const auto file = given_file(arguments)) {
        if (file->empty() || *file == no_config) return {{}, "because of --config none", {}, true};
        return {*file, "named by --config", {}, true};
    }
    if (const char* const named = std::getenv("VVR_CONFIG")) {
        return {named, *named == 0 ? "because VVR_CONFIG is empty" : "named by VVR_CONFIG", {}};
    }
    const std::vector<std::filesystem::path> places = usual_places();
    const auto there = std::ranges::find_if(places, [](const std::filesystem::path& place) {
        std::error_code ignored;
        return std::filesystem::exists(place, ignored);
    });
    return {there == places.end() ? std::filesystem::path() : *there, "found there", places};
}

std::vector<std::string> configurable_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* known : app.get_options()) {
        if (!known->get_configurable()) continue;
        const std::vector<std::string>& all = known->get_lnames();
        names.insert(names.end(), all.begin(), all.end());
    }
    return names;
}

std::shared_ptr<CLI::Config> config_file_reader(const CLI::App& app, std::string command, std::string file,
                                                NamesOfCommands names, FindCamera find_camera,
                                                CameraSections& cameras) {
    return std::make_shared<ConfigFile>(app, std::move(command), std::move(file), std::move(names),
                                        std::move(find_camera), cameras);
}

std::shared_ptr<CLI::Config> given_settings_reader(const CLI::App& app,
                                                   std::span<const std::pair<std::string, std::string>> settings) {
    return std::make_shared<GivenSettings>(app, settings);
}

}  // namespace vvr::options
