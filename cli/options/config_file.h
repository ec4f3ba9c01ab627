#pragma once

#include <istream>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace vvr {

/// A config file: long option names and values, and sections `[COMMAND]` that hold for one command only. A name that
/// no option has is an error, as it would be on the command line.
class ConfigFile : public CLI::ConfigTOML {
  public:
    ConfigFile(const CLI::App& app, std::string command, std::string file)
        : app_(app), command_(std::move(command)), file_(std::move(file)) {}

    std::vector<CLI::ConfigItem> from_config(std::istream& input) const override;

  private:
    const CLI::App& app_;
    std::string command_;
    std::string file_;  ///< for errors
};

}  // namespace vvr
