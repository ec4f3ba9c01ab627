// Config files, with options of each shape.
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/options/config_file.h"
#include "tests/fuzz/input.h"

void vvr::fuzz::check(std::string_view input) {
    CLI::App app;
    std::string text;
    double number = 0;
    std::vector<std::string> list;
    bool flag = false;
    app.add_option("--title", text);
    app.add_option("--threshold", number);
    app.add_option("--match", list);
    app.add_flag("--quiet", flag);
    const auto commands = [&app] {
        const auto all = [&app] { return options::configurable_names(app); };
        return std::vector<options::CommandNames>{{"render", all, all},
                                                  {"info", [] { return std::vector<std::string>{"threshold"}; }}};
    };
    options::CameraSections cameras;
    const auto find_camera = [](const std::vector<std::string>&) { return std::string("gate"); };
    app.config_formatter(options::config_file_reader(app, "render", "vvr.toml", commands, find_camera, cameras));
    std::istringstream stream{std::string(input)};
    try {
        parsed([&] {
            app.parse_from_stream(stream);
            return true;
        });
    } catch (const CLI::ParseError&) {
        return;
    }
}
