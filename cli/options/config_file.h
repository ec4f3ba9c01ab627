#pragma once

#include <istream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/options/config_choice.h"

namespace vvr::options {

/// A config file: long option names and values, and sections `[COMMAND]` for one command each. Lines before the first
/// section apply to every command that has the option. A section or name that no command has is an error. A `preset`
/// sets options that the file does not set.
class ConfigFile : public CLI::ConfigTOML {
  public:
    ConfigFile(const CLI::App& app, std::string command, std::string file, NamesOfCommands names)
        : app_(app), command_(std::move(command)), file_(std::move(file)), names_(std::move(names)) {
        comment('\0');  // removed before CLI11 parses the file
    }

    std::vector<CLI::ConfigItem> from_config(std::istream& input) const override;

  private:
    void check_section(const CLI::ConfigItem& item, const std::vector<CommandNames>& commands) const;
    void refuse(const CLI::ConfigItem& item, const std::vector<CommandNames>& commands) const;

    const CLI::App& app_;
    std::string command_;
    std::string file_;  ///< for error texts
    NamesOfCommands names_;
};

/// Feeds settings from data to CLI11 in place of a config file.
class GivenSettings : public CLI::ConfigTOML {
  public:
    GivenSettings(const CLI::App& app, std::span<const std::pair<std::string, std::string>> settings)
        : app_(app), settings_(settings) {}

    /// \throws Error usage when no option has that name
    std::vector<CLI::ConfigItem> from_config(std::istream& input) const override;

  private:
    const CLI::App& app_;
    std::span<const std::pair<std::string, std::string>> settings_;
};

/// All names of the options that a config file can set.
std::vector<std::string> configurable_names(const CLI::App& app);

}  // namespace vvr::options
