#include <algorithm>

#include <fmt/format.h>

#include "cli/commands/command.h"
#include "cli/options/option.h"
#include "cli/print.h"
#include "cli/versions.h"
#include "core/suggest.h"

namespace vvr {

namespace {

std::string help() {
    std::string text = "vvr: surveillance video as one still picture\n\nUsage: vvr COMMAND [OPTIONS]\n\n";
    for (const Command& command : commands()) text += fmt::format("  vvr {:<8} {}\n", command.name, command.help);
    text += "\n`vvr COMMAND --help` lists a command's options, `vvr --version` the libraries' versions.\n";
    return text;
}

}  // namespace

const std::vector<Command>& commands() {
    static const std::vector<Command> table{
        {"render", "a video as a picture", run_render},
        {"watch", "a live stream as a picture that is drawn anew after each brick", run_watch},
        {"extract", "the data files of a video: scalar fields, flow, seeds", run_extract},
        {"inspect", "one frame's object, flow and seeds side by side", run_inspect},
        {"archive", "every new clip of a folder as a picture and a page, with an index", run_archive},
        {"compare", "whether two pictures are the same but for what a tolerance allows", run_compare},
        {"info", "what a video is, and what a render of it would do and need", run_info},
        {"doctor", "what this machine can do, and what would mend what it can't", run_doctor},
    };
    return table;
}

ExitStatus run_command(Arguments arguments, const Environment& environment) {
    if (arguments.empty()) throw Error(ErrorKind::usage, "no command; `vvr --help` lists them");
    const std::string& name = arguments.front();
    if (name == "--help" || name == "-h" || name == "help") {
        print(help());
        return ExitStatus::done;
    }
    if (name == "--version") {
        print(version_text() + "OpenGL: `vvr doctor` shows the renderers\n");
        return ExitStatus::done;
    }
    const auto command = std::ranges::find(commands(), name, &Command::name);
    if (command == commands().end()) {
        throw Error(ErrorKind::usage, fmt::format("there is no command '{}'{}; `vvr --help` lists them", name,
                                                  did_you_mean(name, names_of(commands()))));
    }
    return command->run(*command, arguments.subspan(1), environment);
}

}  // namespace vvr
