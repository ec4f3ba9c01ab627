#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace vvr {

/// Help with each option's unit and default: `--size WxH [1280x800]`.
class HelpText : public CLI::Formatter {
  public:
    HelpText() { column_width(36); }

    std::string make_option_opts(const CLI::Option* option) const override {
        std::string text;
        if (!option->get_type_name().empty()) text += " " + option->get_type_name();
        if (!option->get_default_str().empty()) text += " [" + option->get_default_str() + "]";
        return text;
    }
};

}  // namespace vvr
