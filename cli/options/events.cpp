#include "cli/options/events.h"

#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/options/option.h"

namespace vvr {

namespace {

constexpr std::array kinds{EventKind::moved, EventKind::stood, EventKind::left, EventKind::taken};
constexpr double most_seconds = 86'400;

std::vector<std::string> kind_names() {
    std::vector<std::string> names;
    for (const EventKind kind : kinds) names.emplace_back(name_of(kind));
    return names;
}

std::set<EventKind> parse_kinds(const std::string& text) {
    std::set<EventKind> chosen;
    for (const std::string& word : CLI::detail::split(text, ',')) {
        const std::string name = parse_name(word, kind_names());
        for (const EventKind kind : kinds) {
            if (name_of(kind) == name) chosen.insert(kind);
        }
    }
    return chosen;
}

}  // namespace

void add_options(CLI::App& app, EventChoice& choice) {
    add_option(app, group::output, choice.kinds,
               {"--events", "KIND,...", fmt::format("{}", fmt::join(kind_names(), ",")),
                "the kinds of event that the report and the page list"},
               parse_kinds);
    add_number(app, group::output, choice.least, {0, most_seconds},
               {"--event-min-seconds", "SECONDS", "0", "shorter events are not listed"});
}

}  // namespace vvr
