#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

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
    /// \param decided options whose value comes from elsewhere, whatever the default
    Metadata settings(const std::string& group, const Metadata& decided = {}) const;

    /// Long names of the options of some groups.
    std::vector<std::string> names(std::initializer_list<const char*> groups) const;

    /// What the user gave for an option by its long name, on the command line or in a config file.
    std::optional<std::string> given(const std::string& option) const;

  private:
    void refuse_leftovers() const;

    std::string command_;
    CLI::App app_;
};

}  // namespace vvr
