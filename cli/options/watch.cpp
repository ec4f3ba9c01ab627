#include "cli/options/watch.h"

#include <array>
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "cli/options/option.h"
#include "core/error.h"
#include "core/image/animation_file.h"
#include "core/image/picture_file.h"

namespace vvr {

void add_options(CLI::App& app, WatchOptions& options) {
    add_option(app, group::input, options.duration,
               {"--duration", "TIME", "", "ends after it: 90s, 10m, 2h, 1d; else SIGTERM or SIGINT does"},
               [](const std::string& text) { return static_cast<double>(parse_duration(text).count()); });
    add_number(app, group::input, options.lag, {0.1, 60},
               {"--lag", "SECONDS", "", "a frame that has waited longer for its turn is dropped; pipes wait instead"});
    add_number(app, group::input, options.patience, {0.5, 3600},
               {"--patience", "SECONDS", "", "without a frame a connection is taken for lost, and made again"});
}

void add_stream_output(CLI::App& app, OutputOptions& output) {
    add_option(app, group::output, output.path,
               {"-o,--output", "FILE", "",
                fmt::format("the picture, replaced after each brick: {}; a page that loads itself again: .html; a "
                            "series, one file for each brick, has a field in its name: {{brick:4}}, #### or %04d",
                            fmt::join(picture_endings(), " "))},
               [](const std::string& given) { return std::filesystem::path(given); });
}

void check_stream(const RenderSettings& settings, const OutputOptions& output) {
    if (output.path.empty()) throw Error(ErrorKind::usage, "no output: say where the picture goes with -o FILE");
    check(output);
    if (is_animation(output.path)) {
        throw Error(ErrorKind::usage, fmt::format("'{}': an animated file is written when it ends, and a stream does "
                                                  "not; take a picture, a page or a series",
                                                  output.path.string()));
    }
    struct {
        bool given;
        const char* option;
        const char* instead;
    } const refused[] = {
        {settings.input.start.has_value(), "--start", "a stream begins now"},
        {settings.input.end.has_value(), "--end", "--duration ends a stream"},
        {!settings.seeds.empty(), "--seeds", "they are for a clip whose frames are known"},
        {settings.look.start_time.as_recorded, "--start-time recorded",
         "a stream is not recorded; give a date and time"},
        {settings.fields.reference == "median", "--reference median",
         "it takes the whole clip; take running, first or a picture"},
    };
    for (const auto& row : refused) {
        if (row.given) throw Error(ErrorKind::usage, fmt::format("{}: {}", row.option, row.instead));
    }
    check(settings, true);
}

}  // namespace vvr
