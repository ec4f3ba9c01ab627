#pragma once

#include <functional>
#include <string>
#include <vector>

namespace vvr::options {

/// A command, and the options of it that a config file can set.
struct CommandNames {
    std::string command;
    std::vector<std::string> options;
};

/// Those of every command. A function, as only a config file asks for them.
using NamesOfCommands = std::function<std::vector<CommandNames>()>;

}  // namespace vvr::options
