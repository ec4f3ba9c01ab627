#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "cli/options/command_line.h"
#include "core/base/error.h"

// How the arguments of the program become texts of options.
namespace vvr::options {

/// Gives the options their texts: `--size 3x3`, `--size=3x3`, `-o FILE`, `-oFILE`, `-qo FILE`. After `--`, all words
/// are inputs. \returns words that look like options but are none
std::vector<std::string> CommandLine::read_arguments(std::span<const std::string> arguments) {
    std::vector<std::string> unknown;
    bool are_inputs = false;
    auto word = arguments.begin();
    const auto give = [&](Option& option, std::optional<std::string> text) {
        if (!text && option.value.shape == Value::Shape::flag) text = "true";
        if (!text && ++word != arguments.end()) text = *word;
        if (!text) {
            throw Error(ErrorCode::usage, fmt::format("--{} needs a value, {}; `vvr {} --help` lists the options",
                                                      option.help.name, option.help.unit, help_.name));
        }
        option.give(std::array{*text}, Source::argument);
    };
    const auto find = [&](const auto& key, auto HelpOption::*member) {
        return std::ranges::find_if(
            options_, [&](const Option& option) { return option.is_visible() && option.help.*member == key; });
    };
    for (; word != arguments.end(); ++word) {
        if (are_inputs || word->size() < 2 || word->front() != '-') {
            inputs_.push_back(*word);
        } else if (*word == "--") {
            are_inputs = true;
        } else if (word->starts_with("--")) {
            const std::size_t equals = word->find('=');
            const auto option = find(word->substr(2, equals - 2), &HelpOption::name);
            if (option == options_.end()) {
                unknown.push_back(*word);
            } else {
                give(*option, equals == std::string::npos ? std::nullopt : std::optional(word->substr(equals + 1)));
            }
        } else {
            for (std::size_t at = 1; at < word->size(); ++at) {
                const auto option = find((*word)[at], &HelpOption::letter);
                if (option == options_.end()) {
                    unknown.push_back(*word);
                    break;
                }
                const bool is_flag = option->value.shape == Value::Shape::flag;
                give(*option, is_flag || at + 1 == word->size() ? std::nullopt : std::optional(word->substr(at + 1)));
                if (!is_flag) break;
            }
        }
    }
    return unknown;
}

/// Refuses the first of the unknown options, and inputs of a command that has none.
void CommandLine::refuse(std::span<const std::string> unknown) const {
    if (unknown.empty()) {
        if (inputs_.empty() || arguments_ != nullptr) return;
        throw Error(ErrorCode::input_unsuitable,
                    fmt::format("'{}' is one argument too many; `vvr {} --help` lists the arguments", inputs_.front(),
                                help_.name));
    }
    const std::string name = unknown.front().substr(0, unknown.front().find('='));
    std::vector<std::string> known;
    for (const Option& option : options_) {
        const std::string dashed = fmt::format("--{}", option.help.name);
        if (name == dashed && !option.not_live_reason.empty())
            throw Error(ErrorCode::option_unknown, fmt::format("{}: {}", name, option.not_live_reason));
        if (option.is_visible()) known.push_back(dashed);
    }
    throw Error(ErrorCode::option_unknown, fmt::format("there is no option '{}'{}; `vvr {} --help` lists them", name,
                                                       did_you_mean(name, known), help_.name));
}

}  // namespace vvr::options
