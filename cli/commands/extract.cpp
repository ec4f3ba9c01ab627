#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cli/command_line.h"
#include "cli/commands/command.h"
#include "cli/render/open_fields.h"
#include "cli/render/shown_name.h"
#include "cli/options/fields.h"
#include "cli/options/input.h"
#include "cli/options/option.h"
#include "cli/options/run.h"
#include "core/words.h"
#include "cli/progress.h"
#include "core/fields/pipeline.h"
#include "core/store/data_folder.h"

namespace vvr {

namespace {

struct ExtractSettings {
    InputOptions input;
    FieldOptions fields;
    RunOptions run;
    std::filesystem::path folder;
    int flow_every = 1;
    bool colour = false;
    std::optional<std::pair<int, int>> part;  ///< the first of the second; none = what --start and --end say
};

void add_options(CLI::App& app, ExtractSettings& settings) {
    add_option(app, group::output, settings.folder,
               {"-o,--output", "DIR", "", "a new or empty folder, or one with an older extraction, which is replaced"},
               [](const std::string& given) { return std::filesystem::path(given); });
    // Its group isn't that of the fields: it changes what is kept, not what a field is.
    add_integer(app, group::output, settings.flow_every, 1, 1'000'000,
                {"--flow-every", "FRAMES", "", "keep flow and seeds of frames whose number is a multiple of it"});
    app.add_flag("--with-color", settings.colour, "keep every frame's picture, for renders with --color video")
        ->group(group::output);
    // What part it is stands in the settings as --start and --end.
    add_option(app, group::output, settings.part,
               {"--part", "I/N", "", "only the I-th of N parts of the clip, 1/N to N/N, as of one extraction of all"},
               [](const std::string& given) { return parse_share(given); });
    add_options(app, settings.input);
    add_options(app, settings.fields);
    add_options(app, settings.run);
}

FieldOptions options_for(const ExtractSettings& settings) {
    FieldOptions options = settings.fields;
    options.threads = settings.run.threads;
    options.flow.every = settings.flow_every;
    options.span = span_of(settings.input);
    return options;
}

/// Where the part begins and ends, for one who has asked for it by number. The last has no end: headers lie.
void choose_part(ExtractSettings& settings, const VideoInfo& clip) {
    if (!settings.part) return;
    if (settings.input.start || settings.input.end) {
        throw Error(ErrorKind::usage, "--part says where to begin and to end; leave out --start and --end");
    }
    const auto [part, count] = *settings.part;
    if (clip.frames < count) {
        throw Error(ErrorKind::usage,
                    fmt::format("--part {}/{}: '{}' tells of {}; ask for fewer parts, or take --start and --end", part,
                                count, clip.name, clip.frames > 0 ? counted(clip.frames, "frame") : "no length"));
    }
    const auto begin = [&, count = count](int number) {
        return Time{static_cast<double>(clip.frames * number / count), Time::Unit::frames};
    };
    if (part > 1) settings.input.start = begin(part - 1);
    if (part < count) settings.input.end = begin(part);
}

/// The options that decide on the fields, and where the part of a clip begins and ends.
Metadata settings_of(const CommandLine& line, const InputOptions& input) {
    Metadata part;
    if (!line.given("start") && input.start) part.emplace_back("start", fmt::format("{}", input.start->value));
    if (!line.given("end") && input.end) part.emplace_back("end", fmt::format("{}", input.end->value));
    Metadata settings;
    for (const char* name : {group::input, group::fields}) {
        for (const auto& [option, value] : line.settings(name, part)) {
            settings.emplace_back(option, without_folder(option, value));
        }
    }
    return settings;
}

}  // namespace

ExitStatus run_extract(const Command& command, Arguments arguments, const Environment& environment) {
    ExtractSettings settings;
    CommandLine line(command.name, command.help);
    add_options(line.app(), settings);
    if (!line.parse(arguments)) return ExitStatus::done;
    apply(settings.run, environment.log);
    if (settings.folder.empty()) throw Error(ErrorKind::usage, "no output: say where the files go with -o DIR");
    only_input(settings.input);
    check_data_folder(settings.folder);
    const auto begin = std::chrono::steady_clock::now();

    constexpr bool colour = true;
    const auto clip = open_clip(settings.input, colour, settings.run.threads);
    choose_part(settings, clip->info());
    const FieldOptions options = options_for(settings);
    const bool flow = options.flow.method != "none";
    Progress progress("frames", expected_frames(clip->info(), options.span),
                      !settings.run.quiet && stderr_is_terminal());
    std::optional<DataFolder> folder;
    std::int64_t frames = 0;
    const FieldSummary summary = compute_fields(*clip, options, [&](const SharedFrame& frame, Field&& field) {
        // Not before there is something to write: an older extraction stays if this one comes to nothing.
        if (!folder) folder.emplace(settings.folder, flow ? settings.flow_every : 0, settings.colour);
        folder->add(*frame, field);
        progress.set(++frames);
    });
    progress.clear();
    Manifest manifest;
    manifest.clip = clip->info();
    manifest.clip.title = shown_name(clip->info().name);
    manifest.span = options.span;
    manifest.field_size = clip->field_size();
    manifest.damaged = summary.damaged;
    manifest.settings = settings_of(line, settings.input);
    {
        const auto held = environment.signals.hold();
        folder->close(std::move(manifest), summary.reference);
    }
    if (summary.damaged > 0) {
        environment.log.warn("'{}': {} of what was read", clip->info().name,
                             counted(summary.damaged, "damaged packet"));
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    environment.log.info("'{}': {} of {}x{}, {:.1f} s", settings.folder.string(), counted(summary.frames, "frame"),
                         clip->field_size().width, clip->field_size().height, took.count());
    return ExitStatus::done;
}

}  // namespace vvr
