#pragma once

#include <span>
#include <string>

#include <CLI/CLI.hpp>

#include "core/image/picture.h"

namespace vvr {

/// The command line of one command: its options, a config file for them, and errors in vvr's own words.
class CommandLine {
  public:
    CommandLine(const std::string& command, const std::string& help);

    /// Options are added to it before `parse`.
    CLI::App& app() { return app_; }

    /// Reads arguments, then the config file for what they leave open.
    /// \returns false when help was asked for, and printed
    /// \throws Error usage, or io when the config file can't be read
    bool parse(std::span<const std::string> arguments);

    /// Long names and values of the options of one group: as given, else the default.
    Metadata settings(const std::string& group) const;

  private:
    void refuse_leftovers() const;

    std::string command_;
    CLI::App app_;
};

}  // namespace vvr
