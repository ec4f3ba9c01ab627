#include "cli/options/bricks.h"

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
    CLI::Option* length = add_option(app, group::bricks, options.length,
                                     {"--brick", "TIME", "", "length of a brick: 75 (frames) or 3s"}, parse_brick);
    add_integer(app, group::bricks, options.count, 1, 256,
                {"--window", "COUNT", "", "bricks that the clip is cut into, without --brick"})
        ->excludes(length);
}

}  // namespace vvr
