#include <algorithm>
#include <chrono>
#include <memory>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "cli/command_line.h"
#include "cli/commands/command.h"
#include "cli/jobs/golden.h"
#include "cli/jobs/open_fields.h"
#include "cli/jobs/page_output.h"
#include "cli/jobs/picture_output.h"
#include "cli/jobs/picture_settings.h"
#include "cli/jobs/plan.h"
#include "cli/jobs/render_clip.h"
#include "cli/jobs/render_series.h"
#include "cli/jobs/report.h"
#include "cli/options/output.h"
#include "cli/options/render_settings.h"
#include "cli/options/words.h"
#include "cli/progress.h"
#include "core/fields/filter.h"
#include "core/image/atomic_file.h"

namespace vvr {

namespace {

/// Whether the fields' filter marks objects, among which there are events to be found.
bool marks_objects(const RenderSettings& settings, const Metadata& extracted) {
    const auto found = std::ranges::find(extracted, "filter", &Metadata::value_type::first);
    return find_filter(found == extracted.end() ? settings.fields.filter : found->second).traits.shows_object;
}

void log_report(const RenderJob& job, const RenderReport& report, spdlog::logger& log) {
    const std::string& name = report.info.name;
    log.debug("backend {}: {}", report.backend, report.renderer);
    log.debug("fields {}x{}, {} arrows", report.field_size.width, report.field_size.height, report.arrows);
    if (report.damaged > 0) {
        log.warn("'{}': {}; shown are {} that decoded", name, counted(report.damaged, "damaged packet"),
                 counted(report.frames, "frame"));
    }
    if (report.frames_missing) {
        log.warn("'{}' holds only the clip's first and last picture; --show frames draws no others", name);
    }
    if (const auto asked = static_cast<std::size_t>(job.keyframes); report.keyframes < asked) {
        log.warn(
            "'{}': {} of {} stand in the picture; which they are is told by the clip's length, and it does not say "
            "that or is shorter",
            name, report.keyframes, counted(job.keyframes, "key frame"));
    }
    if (report.lettering.font_missing) {
        log.warn("fontconfig finds no font, so nothing is written on the picture; install one, fonts-dejavu-core say");
    }
    if (report.still) log.warn("'{}': nothing moves, so the volume is empty; --threshold sets what counts", name);
    if (report.step > 1)
        log.info("{} share a layer, as the clip is longer than the window", counted(report.step, "frame"));
}

RenderReport render(const RenderSettings& settings, const RenderJob& job, FieldSource& source, const PictureSink& sink,
                    spdlog::logger& log) {
    const Plan plan = make_plan(job, source);
    check_memory(plan);
    Progress progress("frames", plan.frames, !settings.run.quiet && stderr_is_terminal());
    const FrameProgress count = [&](std::int64_t frames) { progress.set(frames); };
    const PictureSink write = [&](const RenderReport& so_far, int number, Picture&& picture) {
        progress.clear();
        sink(so_far, number, std::move(picture));
    };
    const RenderReport report =
        job.series ? render_series(job, source, count, write) : render_clip(job, source, count, write);
    log_report(job, report, log);
    return report;
}

/// What the settings ask for, as far as this output needs it.
RenderJob job_of(const RenderSettings& settings, const OutputOptions& output, const OpenedFields& fields) {
    RenderJob job = job_for(settings);
    job.clock = clock_of(settings.look.start_time, fields.source->info());
    job.pictures = pictures_of(output);
    job.series = is_series(output);
    const bool page = !page_of(output).empty();
    job.layers = page || (!output.path.empty() && !is_animation(output.path) && holds_layers(output.path));
    job.events = output.events;
    job.find_events = (page || !output.report.empty()) && marks_objects(settings, fields.extracted);
    return job;
}

/// Puts itself between the fields and who reads them.
WatchedFields* watch(OpenedFields& fields) {
    auto watched = std::make_unique<WatchedFields>(std::move(fields.source));
    WatchedFields* const watcher = watched.get();
    fields.source = std::move(watched);
    return watcher;
}

/// What came of it, in a line.
std::string outcome(const OutputOptions& output, const RenderReport& report) {
    const std::string name = output.path.empty() ? report.info.name : output.path.string();
    const std::string frames = counted(report.frames, "frame");
    if (is_series(output)) return fmt::format("'{}': {} of {}", name, counted(report.pictures, "picture"), frames);
    return fmt::format("'{}': {} in {} and {}", name, frames, counted(report.layers, "layer"),
                       counted(std::ssize(report.bricks), "brick"));
}

}  // namespace

ExitStatus run_render(const Command& command, Arguments arguments, const Environment& environment) {
    RenderSettings settings;
    OutputOptions output;
    CommandLine line(command.name, command.help);
    add_options(line.app(), output);
    add_options(line.app(), settings);
    if (!line.parse(arguments)) return ExitStatus::done;
    apply(settings.run, environment.log);
    check(output);
    check_report(output, settings.input.names);
    const bool series = is_series(output);
    check(settings, series);
    if (pictures_of(output) > 1 && !settings.look.shows("tracelines")) {
        throw Error(ErrorKind::usage,
                    "an animation moves the stripes of tracelines, and none are shown: add them with "
                    "--show volume,tracelines,outline,frames");
    }
    PictureOutput pictures(output, environment.signals);
    const auto begin = std::chrono::steady_clock::now();
    OpenedFields fields = open_fields(settings, line);
    WatchedFields* const watched = page_of(output).empty() ? nullptr : watch(fields);
    Picture drawn;
    const auto write = [&](const RenderReport& report, int number, Picture&& picture) {
        const Metadata description = describe(line, fields.extracted, report, series);
        if (!output.golden.path.empty()) drawn = {picture.pixels, picture.encoding, {}};
        if (!is_page(output)) pictures.add(number, picture, description);
        pictures.add_thumbnail(picture);
        if (watched == nullptr) return;
        pictures.add_page(page_text(page_of(output), settings.input.names.front(), settings.look.title, report,
                                    std::move(picture), description, watched->take()));
    };
    const RenderJob job = job_of(settings, output, fields);
    const RenderReport report = render(settings, job, *fields.source, write, environment.log);
    pictures.close();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    environment.log.info("{}, {:.1f} s", outcome(output, report), took.count());
    if (report.events) environment.log.info("{}", summary_of(*report.events));
    if (!output.report.empty()) {
        const std::string text = format_report(report, settings_of(line, fields.extracted), took.count());
        const auto held = environment.signals.hold();
        replace_file(output.report, std::as_bytes(std::span(text)));
    }
    if (!output.golden.path.empty()) {
        meet_golden(output.golden, drawn, describe(line, fields.extracted, report, series), environment);
    }
    return ExitStatus::done;
}

}  // namespace vvr
