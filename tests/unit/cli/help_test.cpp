#include "cli/options/help.h"

#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/options/command_line.h"
#include "core/base/setting.h"

namespace vvr {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

const options::CommandHelp help{
    .name = "draw",
    .text = "draw something",
    .arguments = "INPUT...",
    .arguments_text = "what is read, and every word of this sentence is short enough to be wrapped",
    .options = {{options::Group::run, 'q', "quiet", "", "say nothing", {}, "", {}},
                {options::Group::look,
                 0,
                 "background",
                 "COLOR",
                 "what is behind all, which takes a line of its own as its name is long",
                 {},
                 "none",
                 {}},
                {options::Group::look, 0, "theme", "NAME", "colours", {}, "light", {{"light", "dark on white"}}}},
    .examples = {{"vvr draw a b", "both"}}};

TEST(Help, IsWrappedToAnyWidth) {
    for (const int width : {72, 80, 120}) {
        for (const std::string& line : lines_of(options::help_text(help, width))) {
            EXPECT_LE(line.size(), static_cast<std::size_t>(width)) << line;
        }
    }
}

TEST(Help, HasGroupsInOrderValuesBelowOptionsAndExamplesLast) {
    const std::string text = options::help_text(help, 80);
    const auto at = [&](const char* part) { return text.find(part); };
    EXPECT_LT(at("Usage: vvr draw INPUT... [OPTIONS]"), at("\nLook:\n"));
    EXPECT_LT(at("\nLook:\n"), at("\nRun:\n"));
    EXPECT_LT(at("  --background COLOR"), at("  --theme NAME"));
    EXPECT_LT(at("  --theme NAME"), at("light          dark on white"));
    EXPECT_LT(at("  -q, --quiet"), at("\nExamples:\n  # both\n  vvr draw a b\n"));
}

TEST(Help, InShortNamesEachOption) {
    EXPECT_EQ(options::short_help_text(help, 80),
              "vvr draw: draw something\n\nUsage: vvr draw INPUT... [OPTIONS]\n\n"
              "  Look          --background --theme\n"
              "  Run           -q, --quiet\n"
              "\nExample: vvr draw a b\n\n`vvr draw --help` describes all options.\n");
}

TEST(Defaults, AreOfTheFirstRowThenOfThoseThatDiffer) {
    struct Row {
        std::string_view name;
        int value;
    };
    const std::vector<Row> rows{{"a", 1}, {"b", 2}, {"c", 1}, {"d", 2}, {"e", 3}};
    EXPECT_EQ(options::defaults_of(rows, [](const Row& row) { return std::to_string(row.value); }), "1; b, d: 2; e: 3");
}

}  // namespace
}  // namespace vvr
