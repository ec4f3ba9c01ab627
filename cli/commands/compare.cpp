#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "cli/command_line.h"
#include "cli/commands/command.h"
#include "cli/options/comparison.h"
#include "cli/options/option.h"
#include "cli/options/run.h"
#include "cli/print.h"
#include "cli/render/show_comparison.h"
#include "core/image/difference_view.h"
#include "core/image/picture_file.h"
#include "core/json_text.h"

namespace vvr {

ExitStatus run_compare(const Command& command, Arguments arguments, const Environment& environment) {
    std::vector<std::string> names;
    bool json = false;
    ComparisonOptions options;
    RunOptions run;
    CommandLine line(command.name, command.help);
    line.app().add_option("A B", names, "two picture files")->type_name("");
    line.app().add_flag("--json", json, "for programs: null where there is no number")->group(group::output);
    add_options(line.app(), options);
    add_talk_options(line.app(), run);
    if (!line.parse(arguments)) return ExitStatus::done;
    apply(run, environment.log);
    if (names.size() != 2) {
        throw Error(ErrorKind::usage,
                    fmt::format("compare takes two pictures, and was given {}: vvr compare A B", names.size()));
    }
    check(options);

    const Samples a = without_pixel_data(read_samples(names[0]));
    const Samples b = without_pixel_data(read_samples(names[1]));
    const Comparison comparison = compare(a, b, options.tolerance);
    if (json) {
        nlohmann::ordered_json told{{"a", names[0]}, {"b", names[1]}};
        told.update(json_of(comparison));
        print(json_text(told, 2) + "\n");
    } else {
        print(numbers_of(comparison));
    }
    if (comparison.has_numbers() && !options.diff.empty()) {
        const auto held = environment.signals.hold();
        write_picture(options.diff, difference_picture(a, comparison));
    }
    if (comparison.verdict == Verdict::same) return ExitStatus::done;
    log_difference(comparison, options.tolerance, environment.log);
    throw Error(ErrorKind::differs, fmt::format("'{}' and '{}' differ: {}", names[0], names[1], comparison.reason));
}

}  // namespace vvr
