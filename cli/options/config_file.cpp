#include "cli/options/config_file.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <sstream>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/footage/input_files.h"
#include "core/footage/recorder_names.h"
#include "core/footage/recording.h"
#include "core/media/input.h"

namespace vvr::options {

namespace {

constexpr PresetSetting day[] = {{"time", "busy"},
                                 {"brick", "01:00:00"},
                                 {"show",
                                  "volume,portraits,map,strip,numbers,outline,ribs,frames,ends,"
                                  "ruler,legend,title,explanation,bricks"}};

// The paper's method and figures; default values where the paper gives none.
constexpr PresetSetting paper[] = {
    {"illumination", "none"},     // colour and light unchanged
    {"shadows", "keep"},          //
    {"stabilize", "off"},         //
    {"flow", "horn-schunck"},     // §4.1: 60 steps with λ = 100, which is α²; the derivatives of [BFB94]
    {"solver", "jacobi"},         //
    {"iterations", "60"},         //
    {"alpha", "10"},              //
    {"derivatives", "barron"},    //
    {"seed-area", "object"},      // §4.2: by the flow and the difference object, the fastest first
    {"seed-order", "magnitude"},  //
    {"layout", "horseshoe"},      // §5.1
    {"time-velocity", "0"},       // §5.2
    {"theme", "light"},           // the figures: dark objects on white, arrows from yellow to red, no text
    {"color", "transfer"},        //
    {"transfer", "grey"},         //
    {"shading", "none"},          //
    {"show", "volume,arrows"},
    {"background", "#ffffff"}};

constexpr std::array table{
    Preset{"day", "a recording of many hours: more room for motion, one brick per hour", day, true},
    Preset{"paper", "the method and the look of the paper (docs/paper.md)", paper},
};

}  // namespace

std::span<const Preset> presets() {
    return table;
}

std::span<const PresetSetting> settings_of_preset(std::string_view name) {
    const auto preset = std::ranges::find(table, name, &Preset::name);
    return preset == table.end() ? std::span<const PresetSetting>() : preset->settings;
}

namespace {

constexpr std::string_view no_config = "none";
constexpr std::string_view camera_section = "camera.";

Error invalid_config(const std::string& file, const std::string& what) {
    return {ErrorCode::config_invalid, fmt::format("the config file '{}' {}", file, what)};
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

/// The file without comments. CLI11 would take any # for a comment, even the one of a quoted colour.
std::istringstream without_comments(const std::string& file) {
    std::istringstream input(file);
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

/// The name of a section, which may have quotes.
std::string unquoted(const std::string& name) {
    const bool is_quoted =
        name.size() > 2 && name.front() == name.back() && (name.front() == '"' || name.front() == '\'');
    return is_quoted ? name.substr(1, name.size() - 2) : name;
}

/// A section that is there twice would be joined without a word.
void refuse_sections_twice(const std::string& text, const std::string& file) {
    std::istringstream lines(text);
    std::map<std::string, int> first_lines;
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        line.erase(0, line.find_first_not_of(" \t"));
        if (!line.starts_with('[')) continue;
        std::string section = line.substr(0, line.find(']')) + "]";
        std::erase_if(section, [](char letter) { return letter == '"' || letter == '\''; });
        const auto [first, is_new] = first_lines.emplace(section, number);
        if (is_new) continue;
        throw Error(ErrorCode::config_invalid,
                    fmt::format("'{}': lines {} and {} both begin the section {}; rename one of them", file,
                                first->second, number, first->first));
    }
}

/// Refuses a name that is not among the known ones.
void check_name(const std::string& name, std::span<const std::string> known, const std::string& file,
                const std::string& whose) {
    if (std::ranges::find(known, name) != known.end()) return;
    throw invalid_config(file, fmt::format("sets '{}'{}{}", name, whose, did_you_mean(name, known)));
}

}  // namespace

std::vector<Section> sections_of(const std::string& text, const std::string& file) {
    refuse_sections_twice(text, file);
    CLI::ConfigTOML format;
    format.comment('\0');  // removed before CLI11 parses the file
    std::vector<Section> sections{{}};
    try {
        std::istringstream plain = without_comments(text);
        const std::vector<CLI::ConfigItem> items = format.from_config(plain);
        for (auto one = items.begin(); one != items.end(); ++one) {
            const CLI::ConfigItem& item = *one;
            // CLI11 marks the beginning and the end of a section with these, and of those that contain it.
            const bool begins = item.name == "++";
            const auto next = one + 1;
            const bool contains =
                next != items.end() && next->name == "++" && next->parents.size() > item.parents.size();
            if (item.name == "--" || (begins && contains)) continue;
            const std::string name = unquoted(fmt::format("{}", fmt::join(item.parents, ".")));
            auto section = std::ranges::find(sections, name, &Section::name);
            if (section == sections.end()) section = sections.insert(sections.end(), {name});
            if (!begins) section->settings.emplace_back(item.name, item.inputs);
        }
    } catch (const CLI::Error& error) {
        throw Error(ErrorCode::config_invalid,
                    fmt::format("cannot read '{}': {}; write lines such as `size = 320x200`", file, error.what()));
    }
    return sections;
}

std::vector<Section> read_sections(const std::filesystem::path& file) {
    return sections_of(read_file(file.string(), most_bytes::text), file.string());
}

std::string camera_of(const Section& section) {
    return section.name.starts_with(camera_section) ? unquoted(section.name.substr(camera_section.size())) : "";
}

std::vector<std::string> cameras_of(std::span<const Section> sections) {
    std::vector<std::string> cameras;
    for (const Section& section : sections) {
        if (std::string camera = camera_of(section); !camera.empty()) cameras.push_back(std::move(camera));
    }
    return cameras;
}

void check_sections(std::span<const Section> sections, const std::string& file,
                    const std::vector<CommandNames>& commands) {
    std::vector<std::string> all;
    std::vector<std::string> of_cameras;
    std::vector<std::string> names;
    for (const CommandNames& row : commands) {
        all.insert(all.end(), row.options.begin(), row.options.end());
        of_cameras.insert(of_cameras.end(), row.camera_options.begin(), row.camera_options.end());
        names.push_back(row.command);
    }
    for (const Section& section : sections) {
        const auto command = std::ranges::find(commands, section.name, &CommandNames::command);
        const std::string camera = camera_of(section);
        if (section.name == "camera" && !section.settings.empty()) {
            throw invalid_config(file, "has a section [camera] without the name of a camera; write [camera.NAME]");
        }
        if (!section.name.empty() && section.name != "camera" && camera.empty() && command == commands.end()) {
            throw invalid_config(file, fmt::format("has a section [{}], but there is no such command{}", section.name,
                                                   did_you_mean(section.name, names)));
        }
        for (const auto& [name, values] : section.settings) {
            if (!camera.empty()) {
                check_name(name, of_cameras, file,
                           fmt::format(" in [camera.{}], which is not an option for the videos of one camera", camera));
            } else if (section.name.empty()) {
                check_name(name, all, file, ", which no command has");
            } else {
                check_name(name, command->options, file, fmt::format(", which `vvr {}` does not have", section.name));
            }
        }
    }
}

ConfigChoice find_config(const std::optional<std::string>& given) {
    if (given) {
        if (given->empty() || *given == no_config) return {{}, "because of --config none", {}, true};
        return {*given, "named by --config", {}, true};
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

std::vector<Section> read_config(const ConfigChoice& config, const std::vector<CommandNames>& commands) {
    const std::string file = config.file.string();
    check_is_file(file, most_bytes::text);
    std::string text;
    try {
        text = read_file(file, most_bytes::text);
    } catch (const Error&) {
        throw Error(ErrorCode::io, fmt::format("cannot read config file '{}', {}; check the name and its permissions",
                                               file, config.why));
    }
    std::vector<Section> sections = sections_of(text, file);
    check_sections(sections, file, commands);
    return sections;
}

std::string camera_of_input(const std::vector<std::string>& inputs, const std::vector<std::string>& patterns,
                            std::span<const std::string> known) {
    if (inputs.empty() || inputs.front().starts_with('@') || media::is_url(inputs.front())) return {};
    std::vector<std::string> files;
    try {
        files = footage::files_of_inputs(inputs);
    } catch (const Error&) {
        return {};  // opening the input reports it
    }
    // Folders in front of a recording may name the camera too.
    std::error_code none;
    const std::string& input = inputs.front();
    if (files.empty()) files.push_back(std::filesystem::is_directory(input, none) ? input + "/clip" : input);
    for (std::string& file : files) file = std::filesystem::absolute(file, none).lexically_normal().string();
    footage::RecorderNames names(patterns);
    names.compare(files);
    for (const std::string& section : known) names.describe_camera(section, {});
    const std::string camera = names.camera_of(files.front());
    const bool is_one = std::ranges::all_of(files, [&](const auto& file) { return names.camera_of(file) == camera; });
    return is_one ? camera : std::string();
}

}  // namespace vvr::options
