#include <algorithm>

#include <fmt/format.h>

#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/options/add_option.h"
#include "cli/options/presets.h"
#include "core/base/error.h"
#include "core/base/setting.h"
#include "core/base/text.h"

namespace vvr::commands {

namespace {

constexpr Setting camera_name{"camera-name", "NAME", "also apply the section [camera.NAME] of the config file"};

/// Sets a command's options as the config file does, without other arguments.
void read(options::CommandLine& line, const options::ConfigChoice& choice, const std::string& preset = {},
          const std::string& camera = {}) {
    if (!camera.empty()) line.set_camera(camera);
    std::vector<std::string> arguments;
    // Without --config the file is searched for again, so that errors say how it was found.
    if (choice.file.empty()) {
        arguments.emplace_back("--config=none");
    } else if (choice.is_given) {
        arguments.push_back(fmt::format("--config={}", choice.file.string()));
    }
    if (!preset.empty()) arguments.push_back(fmt::format("--{}={}", setting::preset.name, preset));
    line.parse(arguments);
}

std::string file_line(const options::ConfigChoice& choice) {
    if (!choice.file.empty())
        return fmt::format("config file: {} ({})\n", shown_text(choice.file.string()), choice.why);
    std::string text = "config file: none";
    if (choice.places.empty()) return text + fmt::format(" ({})\n", choice.why);
    text += "; looked for";
    for (const std::filesystem::path& place : choice.places) text += fmt::format(" {}", shown_text(place.string()));
    return text + "\n";
}

/// For each command, the options that the config file sets.
std::string settings_of_all(const options::ConfigChoice& choice) {
    std::string text;
    for (const CommandRow& row : command_rows) {
        CommandAndLine command(row);
        try {
            read(command.line, choice);
        } catch (const Error& error) {
            // An unknown name is an error for all commands; an invalid value may be one for this command only.
            if (error.kind() != ErrorKind::usage || error.about().names().empty()) throw;
            text += fmt::format("vvr {}: {}\n", row.name, error.what());
            continue;
        }
        for (const options::OptionValue& option : command.line.given(options::all_groups)) {
            if (option.name != "config")
                text += fmt::format("vvr {}: {} = {}\n", row.name, option.name, shown_text(option.value));
        }
    }
    return text;
}

/// For each camera with a section, the options that it sets for an archive, which has all of them.
std::string settings_of_cameras(const options::ConfigChoice& choice) {
    CommandAndLine archive(find_command("archive"));
    std::string text;
    try {
        read(archive.line, choice);
    } catch (const Error&) {
        return {};  // the command's own lines say it
    }
    for (const std::string& camera : archive.line.cameras().names) {
        CommandAndLine own(find_command("archive"));
        try {
            read(own.line, choice, {}, camera);
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::usage || error.about().names().empty()) throw;
            text += fmt::format("camera {}: {}\n", shown_text(camera), error.what());
            continue;
        }
        const std::vector<std::string>& sets = own.line.cameras().sets;
        for (const options::OptionValue& option : own.line.given(options::all_groups)) {
            if (std::ranges::find(sets, option.name) != sets.end())
                text += fmt::format("camera {}: {} = {}\n", shown_text(camera), option.name, shown_text(option.value));
        }
    }
    return text;
}

/// All options of a command: the value, and what sets it.
std::string settings_of(const CommandRow& row, const options::ConfigChoice& choice, const std::string& preset,
                        const std::string& camera) {
    CommandAndLine command(row);
    options::CommandLine& line = command.line;
    read(line, choice, preset, camera);
    const std::vector<std::string>& of_camera = line.cameras().sets;
    std::string text;
    const auto of_preset = options::settings_of_preset(preset);
    const std::vector<options::OptionValue> given = line.given(options::all_groups);
    for (const options::OptionValue& option : line.values(options::all_groups)) {
        if (option.name == "config" || option.name == "camera-name" || option.name == "help") continue;
        const bool set = std::ranges::find(given, option.name, &options::OptionValue::name) != given.end();
        // The preset given here takes precedence over the config file.
        const bool preset_sets =
            (!preset.empty() && option.name == setting::preset.name) ||
            std::ranges::any_of(of_preset, [&](const auto& one) { return one.first == option.name; });
        const bool camera_sets = std::ranges::find(of_camera, option.name) != of_camera.end();
        const std::string by = preset_sets   ? fmt::format("preset {}", preset)
                               : camera_sets ? fmt::format("config file, [camera.{}]", line.cameras().chosen)
                               : set         ? "config file"
                                             : "default";
        text += fmt::format("{:<20} {} ({})\n", option.name, option.value.empty() ? "-" : shown_text(option.value), by);
    }
    return text;
}

class Config final : public Command {
  public:
    void add_options(options::CommandLine& line) override {
        line.arguments(names_, "[COMMAND]",
                       "list the options of this command and their values; default: list what the config file sets");
        line.only_find_config();
        line.value(options::Group::output, setting::preset, "",
                   [this](const std::string& given) {
                       preset_ = choose(setting::preset.name, given, options::presets()).name;
                   },
                   {.values = options::values_of(options::presets())});
        options::AddOptions(line, options::Group::run)(camera_name, camera_, options::OptionExtra{});
        line.examples({{"vvr config", "the active config file, and what it sets"},
                       {"vvr config render", "every option of render, and what sets it"},
                       {"vvr config render --config none", "the defaults"},
                       {"vvr config render --preset paper", "the options that a preset sets"}});
    }

    cli::ExitStatus run(const options::CommandLine& line, const cli::Environment&) override {
        const options::ConfigChoice& choice = line.config();
        if (names_.size() > 1)
            throw Error(ErrorCode::input_unsuitable,
                        fmt::format("`vvr config` accepts only one COMMAND; remove '{}'", names_[1]));
        std::string text = file_line(choice);
        if (names_.empty() && !preset_.empty()) {
            throw Error(ErrorCode::option_needs_another,
                        fmt::format("--preset needs a COMMAND, for example: vvr config render --preset {}", preset_));
        }
        if (names_.empty() && !camera_.empty()) {
            throw Error(ErrorCode::option_needs_another,
                        fmt::format("--camera-name needs a COMMAND, for example: vvr config archive --camera-name {}",
                                    camera_));
        }
        if (names_.empty()) {
            if (!choice.file.empty()) text += settings_of_all(choice) + settings_of_cameras(choice);
        } else {
            text += settings_of(find_command(names_.front()), choice, preset_, camera_);
        }
        cli::print(text);
        return cli::ExitStatus::done;
    }

  private:
    std::vector<std::string> names_;
    std::string preset_;
    std::string camera_;
};

}  // namespace

std::unique_ptr<Command> make_config() {
    return std::make_unique<Config>();
}

}  // namespace vvr::commands
