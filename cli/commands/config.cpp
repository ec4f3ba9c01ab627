#include <algorithm>

#include <fmt/format.h>

#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/options/command_line.h"
#include "cli/options/config_file.h"
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

/// The options that the config file sets, at least with this precedence.
/// \param read sets the command's options
template <class Read>
std::string settings_from(const std::string& whose, CommandAndLine& command, options::Source least, const Read& read) {
    std::string text;
    try {
        read(command.line);
    } catch (const Error& error) {
        // An unknown name is an error for all commands; an invalid value may be one for this command only.
        if (error.kind() != ErrorKind::usage || error.about().names().empty()) throw;
        return fmt::format("{}: {}\n", whose, error.what());
    }
    for (const options::OptionValue& option : command.line.given(options::all_groups)) {
        if (option.source >= least && options::is_config(option.source))
            text += fmt::format("{}: {} = {}\n", whose, option.name, shown_text(option.value));
    }
    return text;
}

/// For each command, the options that the config file sets, and for each camera with a section those that it sets for
/// an archive, which has all of them.
std::string settings_of_all(const options::ConfigChoice& choice) {
    std::string text;
    for (const CommandRow& row : command_rows) {
        CommandAndLine command(row);
        text += settings_from(fmt::format("vvr {}", row.name), command, options::Source::config,
                              [&](options::CommandLine& line) { read(line, choice); });
    }
    CommandAndLine archive(find_command("archive"));
    try {
        read(archive.line, choice);
    } catch (const Error&) {
        return text;  // the command's own line says it
    }
    for (const std::string& camera : archive.line.cameras()) {
        CommandAndLine own(find_command("archive"));
        text += settings_from(fmt::format("camera {}", shown_text(camera)), own, options::Source::camera,
                              [&](options::CommandLine& line) { line.parse_for_camera(archive.line, camera); });
    }
    return text;
}

/// All options of a command: the value, and what sets it.
std::string settings_of(const CommandRow& row, const options::ConfigChoice& choice, const std::string& preset,
                        const std::string& camera) {
    CommandAndLine command(row);
    options::CommandLine& line = command.line;
    read(line, choice, preset, camera);
    const std::vector<std::string> names = line.configurable();
    std::string text;
    for (const options::OptionValue& option : line.values(options::all_groups)) {
        if (std::ranges::find(names, option.name) == names.end()) continue;
        const std::string by = option.source == options::Source::none ? "default"
                               : option.source == options::Source::camera
                                   ? fmt::format("config file, [camera.{}]", line.camera())
                               : options::is_config(option.source) ? "config file"
                                                                   : fmt::format("preset {}", preset);
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
        line.add(options::Group::output, setting::preset,
                 options::choice_of(
                     setting::preset, options::presets(), false,
                     [this](const options::Preset& preset) { preset_ = preset.name; }, [] { return std::string(); }));
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
            if (!choice.file.empty()) text += settings_of_all(choice);
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
