// Config files.
#include <string>

#include "cli/options/config_file.h"
#include "tests/fuzz/input.h"

void vvr::fuzz::check(std::string_view input) {
    const std::vector<options::CommandNames> commands{{"render", {"title", "threshold"}, {"threshold"}},
                                                      {"archive", {"match"}, {}}};
    parsed([&] {
        const auto sections = options::sections_of(std::string(input), "vvr.toml");
        require(!sections.empty() && sections.front().name.empty(), "the first section is the general one");
        options::check_sections(sections, "vvr.toml", commands);
        return options::cameras_of(sections);
    });
}
