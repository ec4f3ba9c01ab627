#pragma once

#include <map>
#include <string>

#include <CLI/CLI.hpp>

namespace vvr {

/// Help with the unit, the default and the range of each option: `--fov DEGREES [30, 0..150]`.
class HelpText : public CLI::Formatter {
  public:
    using Ranges = std::map<const CLI::Option*, std::string>;

    /// \param ranges of those options that have one; outlives this
    explicit HelpText(const Ranges& ranges) : ranges_(ranges) { column_width(36); }

    std::string make_option_opts(const CLI::Option* option) const override {
        std::string text;
        if (!option->get_type_name().empty()) text += " " + option->get_type_name();
        std::string bracket = option->get_default_str();
        if (const auto range = ranges_.find(option); range != ranges_.end()) {
            bracket += (bracket.empty() ? "" : ", ") + range->second;
        }
        if (!bracket.empty()) text += " [" + bracket + "]";
        return text;
    }

  private:
    const Ranges& ranges_;
};

}  // namespace vvr
