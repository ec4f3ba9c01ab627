#include <algorithm>
#include <initializer_list>

#include <fmt/format.h>

#include "cli/commands/command.h"
#include "cli/options/talk.h"
#include "cli/print.h"
#include "core/error.h"
#include "core/shown_text.h"

namespace vvr {

namespace {

constexpr std::initializer_list<Group> every_group{Group::input,      Group::fields, Group::bricks,  Group::view,
                                                   Group::look,       Group::output, Group::archive, Group::workers,
                                                   Group::comparison, Group::run};

/// A command's options as a config file has them, without anything on the command line.
void read(CommandLine& line, Command& command, TalkOptions& talk, const std::filesystem::path& file) {
    command.add_options(line);
    add_talk_options(line, talk);
    const std::vector<std::string> arguments{file.empty() ? std::string("--no-config")
                                                          : fmt::format("--config={}", file.string())};
    line.parse(arguments);
}

std::string file_line(const ConfigChoice& choice) {
    if (!choice.file.empty())
        return fmt::format("config file: {} ({})\n", shown_text(choice.file.string()), choice.why);
    std::string text = "config file: none";
    if (choice.places.empty()) return text + fmt::format(" ({})\n", choice.why);
    text += "; looked for";
    for (const std::filesystem::path& place : choice.places) text += fmt::format(" {}", shown_text(place.string()));
    return text + "\n";
}

/// What the file sets for each command that it holds for.
std::string settings_of_all(const std::filesystem::path& file) {
    std::string text;
    for (const CommandRow& row : commands()) {
        const std::unique_ptr<Command> command = row.make();
        TalkOptions talk;
        CommandLine line(std::string(row.name), std::string(row.help));
        try {
            read(line, *command, talk, file);
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::usage) throw;
            text += fmt::format("vvr {}: {}\n", row.name, error.what());
            continue;
        }
        for (const OptionValue& option : line.given(every_group)) {
            if (option.name != "config")
                text += fmt::format("vvr {}: {} = {}\n", row.name, option.name, shown_text(option.value));
        }
    }
    return text;
}

/// Every option of one command: its value, and who sets it.
std::string settings_of(const CommandRow& row, const std::filesystem::path& file) {
    const std::unique_ptr<Command> command = row.make();
    TalkOptions talk;
    CommandLine line(std::string(row.name), std::string(row.help));
    read(line, *command, talk, file);
    std::string text;
    const std::vector<OptionValue> given = line.given(every_group);
    for (const OptionValue& option : line.values(every_group)) {
        if (option.name == "config" || option.name == "no-config" || option.name == "help") continue;
        const bool set = std::ranges::find(given, option.name, &OptionValue::name) != given.end();
        text += fmt::format("{:<20} {} ({})\n", option.name, option.value.empty() ? "-" : shown_text(option.value),
                            set ? "config file" : "default");
    }
    return text;
}

class Config final : public Command {
  public:
    void add_options(CommandLine& line) override {
        line.arguments(names_, "[COMMAND]",
                       "whose options are listed, with their values; what the file sets if not given");
        line.only_find_config();
        line.examples({{"vvr config", "which config file is in force, and what it sets"},
                       {"vvr config render", "every option of render, and who sets it"},
                       {"vvr config render --no-config", "the defaults"}});
    }

    ExitStatus run(const CommandLine& line, const Environment&) override {
        const ConfigChoice& choice = line.config();
        if (names_.size() > 1)
            throw Error(ErrorKind::usage,
                        fmt::format("'{}' is one argument too many; `vvr config` takes one COMMAND", names_[1]));
        std::string text = file_line(choice);
        if (names_.empty()) {
            if (!choice.file.empty()) text += settings_of_all(choice.file);
        } else {
            text += settings_of(find_command(names_.front()), choice.file);
        }
        print(text);
        return ExitStatus::done;
    }

  private:
    std::vector<std::string> names_;
};

}  // namespace

std::unique_ptr<Command> make_config() {
    return std::make_unique<Config>();
}

}  // namespace vvr
