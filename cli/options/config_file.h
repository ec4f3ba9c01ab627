#pragma once

#include <istream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/options/config_choice.h"

namespace vvr::options {

/// A config file: long option names and values, and sections `[COMMAND]` that hold for one command only. What stands
/// above all sections holds for every command that has such an option. A section or a name that no command has is an
/// error, as it would be on the command line. A `preset` sets what the file leaves open.
class ConfigFile : public CLI::ConfigTOML {
  public:
    ConfigFile(const CLI::App& app, std::string command, std::string file, NamesOfCommands names)
        : app_(app), command_(std::move(command)), file_(std::move(file)), names_(std::move(names)) {
        comment('\0');  // they are taken out before
    }

    std::vector<CLI::ConfigItem> from_config(std::istream& input) const override;

  private:
    void check_section(const CLI::ConfigItem& item, const std::vector<CommandNames>& commands) const;
    void refuse(const CLI::ConfigItem& item, const std::vector<CommandNames>& commands) const;

    const CLI::App& app_;
    std::string command_;
    std::string file_;  ///< for errors
    NamesOfCommands names_;
};

/// Settings that are there as data, in the place of a config file.
class GivenSettings : public CLI::ConfigTOML {
  public:
    GivenSettings(const CLI::App& app, std::span<const std::pair<std::string, std::string>> settings)
        : app_(app), settings_(settings) {}

    /// \throws Error usage for a name that no option has
    std::vector<CLI::ConfigItem> from_config(std::istream& input) const override;

  private:
    const CLI::App& app_;
    std::span<const std::pair<std::string, std::string>> settings_;
};

/// The options of a command that a config file can set, by all their names.
std::vector<std::string> configurable_names(const CLI::App& app);

}  // namespace vvr::options
