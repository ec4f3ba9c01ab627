#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "cli/command_line.h"
#include "cli/commands/command.h"
#include "cli/render/find_frame.h"
#include "cli/render/inspection.h"
#include "cli/options/fields.h"
#include "cli/options/input.h"
#include "cli/options/option.h"
#include "cli/options/run.h"
#include "core/fields/pipeline.h"
#include "core/image/picture_file.h"

namespace vvr {

namespace {

struct InspectSettings {
    InputOptions input;
    FieldOptions fields;
    RunOptions run;
    std::optional<Time> frame;
    std::filesystem::path path;
};

void add_options(CLI::App& app, InspectSettings& settings) {
    add_option(app, group::output, settings.path,
               {"-o,--output", "FILE", "", fmt::format("the picture: {}", fmt::join(picture_endings(), " "))},
               [](const std::string& given) { return std::filesystem::path(given); });
    add_clip_options(app, settings.input);
    add_option(app, group::input, settings.frame, {"--frame", "TIME", "", "which one: 250, 12.5s or 00:00:12.5"},
               parse_time);
    add_options(app, settings.fields);
    add_options(app, settings.run);
}

/// The fields of one frame: the others only serve as its neighbours.
FieldOptions only(const FoundFrame& frame, const InspectSettings& settings) {
    FieldOptions options = settings.fields;
    options.threads = settings.run.threads;
    options.span.first = frame.index;
    options.span.stop = frame.index + 1;
    return options;
}

}  // namespace

ExitStatus run_inspect(const Command& command, Arguments arguments, const Environment& environment) {
    InspectSettings settings;
    CommandLine line(command.name, command.help);
    add_options(line.app(), settings);
    if (!line.parse(arguments)) return ExitStatus::done;
    apply(settings.run, environment.log);
    only_input(settings.input);
    if (!settings.frame) throw Error(ErrorKind::usage, "no frame: say which with --frame 250, 12.5s or 00:00:12.5");
    if (settings.path.empty()) throw Error(ErrorKind::usage, "no output: say where the picture goes with -o FILE");
    check_picture_path(settings.path);

    constexpr bool colour = true;
    const auto clip = open_clip(settings.input, colour, settings.run.threads);
    const FoundFrame found = frame_at(*clip, *settings.frame, "--frame");
    Inspection inspection;
    compute_fields(*clip, only(found, settings), [&](const SharedFrame& frame, const Field& field) {
        if (field.index == found.index) inspection = inspect(*frame, field);
    });
    if (!inspection.captions) {
        environment.log.warn("fontconfig finds no font, so '{}' has no captions; install one, fonts-dejavu-core say",
                             settings.path.string());
    }
    const auto held = environment.signals.hold();
    write_picture(settings.path, inspection.picture);
    environment.log.info("'{}': frame {} at {:.3f} s", settings.path.string(), found.index, found.pts);
    return ExitStatus::done;
}

}  // namespace vvr
