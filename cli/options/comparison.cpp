#include "cli/options/comparison.h"

#include <fmt/format.h>

#include "cli/options/option.h"
#include "core/image/picture_file.h"

namespace vvr {

namespace {

std::filesystem::path as_path(const std::string& given) {
    return given;
}

}  // namespace

void add_options(CLI::App& app, ComparisonOptions& options) {
    add_number(app, group::comparison, options.tolerance.level, {0, 1},
               {"--tolerance", "LEVEL", "", "a pixel is off where a channel differs by more"});
    add_number(app, group::comparison, options.tolerance.percent, {0, 100},
               {"--tolerance-percent", "PERCENT", "", "of the pixels may be off"});
    add_number(app, group::comparison, options.tolerance.patch, {0, 1},
               {"--tolerance-patch", "LEVEL", "",
                fmt::format("mean difference that a patch of {0}x{0} pixels may have", patch_size)});
    add_option(app, group::comparison, options.diff,
               {"--diff", "FILE", "", "a picture of the differences: yellow = small, red, black = all of the range"},
               as_path);
}

void add_options(CLI::App& app, GoldenOptions& options) {
    add_option(app, group::comparison, options.path,
               {"--golden", "FILE", "", "compare with this picture; another one is exit status 7, and stays beside it"},
               as_path);
    app.add_flag("--bless", options.bless, "make the picture the golden one instead of comparing")
        ->group(group::comparison);
    add_options(app, options.comparison);
}

void check(const ComparisonOptions& options) {
    if (!options.diff.empty()) check_picture_path(options.diff);
}

void check(const GoldenOptions& options) {
    check(options.comparison);
    if (!options.path.empty()) {
        if (options.bless && !options.comparison.diff.empty()) {
            throw Error(ErrorKind::usage, "--bless compares nothing, so there is nothing for --diff to show");
        }
        // A folder that is only there to be read is as good to compare with.
        return options.bless ? check_picture_path(options.path) : check_picture_ending(options.path);
    }
    if (options.bless) throw Error(ErrorKind::usage, "--bless: say which picture is to be blessed with --golden FILE");
    if (!options.comparison.diff.empty()) {
        throw Error(ErrorKind::usage, "--diff: say what the picture is compared with with --golden FILE");
    }
}

}  // namespace vvr
