#include "cli/options/option.h"

#include <fmt/format.h>

namespace vvr {

CLI::Option* add_number(CLI::App& app, const char* group, double& target, Range range, OptionText text) {
    text.standard = fmt::format("{}", target);
    text.help += fmt::format(", {}..{}", range.low, range.high);
    return add_option(app, group, target, text,
                      [range](const std::string& given) { return parse_number(given, range); });
}

CLI::Option* add_integer(CLI::App& app, const char* group, int& target, int low, int high, OptionText text) {
    if (text.standard.empty()) text.standard = fmt::format("{}", target);
    text.help += fmt::format(", {}..{}", low, high);
    return add_option(app, group, target, text, [low, high](const std::string& given) {
        return static_cast<int>(parse_integer(given, low, high));
    });
}

CLI::Option* add_number(CLI::App& app, const char* group, std::optional<double>& target, Range range, OptionText text) {
    text.help += fmt::format(", {}..{}", range.low, range.high);
    return add_option(app, group, target, text,
                      [range](const std::string& given) { return parse_number(given, range); });
}

CLI::Option* add_integer(CLI::App& app, const char* group, std::optional<int>& target, int low, int high,
                         OptionText text) {
    text.help += fmt::format(", {}..{}", low, high);
    return add_option(app, group, target, text, [low, high](const std::string& given) {
        return static_cast<int>(parse_integer(given, low, high));
    });
}

CLI::Option* add_text(CLI::App& app, const char* group, std::string& target, OptionText text) {
    text.standard = target;
    return add_option(app, group, target, text, [](const std::string& given) { return given; });
}

CLI::Option* add_name(CLI::App& app, const char* group, std::string& target, std::vector<std::string> names,
                      OptionText text) {
    text.standard = target;
    text.help += fmt::format(": {}", fmt::join(names, ", "));
    return add_option(app, group, target, text,
                      [names = std::move(names)](const std::string& given) { return parse_name(given, names); });
}

}  // namespace vvr
