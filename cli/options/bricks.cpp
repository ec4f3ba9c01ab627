#include "cli/options/bricks.h"

#include <fmt/format.h>

#include "cli/options/option.h"
#include "core/error.h"

namespace vvr {

namespace {

Time parse_brick(const std::string& text) {
    const Time length = parse_time(text);
    if (length.value <= 0) throw Error(ErrorKind::usage, "a brick has to be longer than nothing");
    return length;
}

}  // namespace

void add_options(CLI::App& app, BrickOptions& options) {
    add_option(app, group::bricks, options.length,
               {"--brick", "TIME", "",
                "length of a brick: 75 (frames) or 3s; in a series 10s if not given, less in a short clip"},
               parse_brick);
    add_integer(
        app, group::bricks, options.count, 1, 256,
        {"--window", "COUNT", fmt::format("{}", standard_window),
         "bricks that are visible at a time: in a series the window that slides, else what the clip is cut into "
         "without --brick"});
    add_number(
        app, group::bricks, options.skip_idle, {0, 86'400},
        {"--skip-idle", "SECONDS", "",
         "of stretches without motion that are longer, the rest is left out, and the ruler says so; 0 = nothing is"});
}

void check(const BrickOptions& options, bool series) {
    if (series && options.skip_idle > 0) {
        throw Error(ErrorKind::usage,
                    "--skip-idle is for one picture of a clip; the pictures of a series share one scale of time");
    }
    if (series || !options.length || !options.count) return;
    throw Error(ErrorKind::usage,
                "--brick excludes --window where one picture shows the whole clip; leave one of them out, or write a "
                "series: -o out.{brick:4}.png");
}

}  // namespace vvr
