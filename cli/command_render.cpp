#include <chrono>
#include <filesystem>

#include <fmt/format.h>

#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/option.h"
#include "cli/options_output.h"
#include "cli/plan.h"
#include "cli/progress.h"
#include "cli/render_clip.h"
#include "cli/render_settings.h"
#include "cli/words.h"
#include "core/image/picture_file.h"

namespace vvr {

namespace {

/// The settings that made the picture, and what they made of this clip.
Metadata describe(const CommandLine& line, const RenderReport& report) {
    Metadata metadata;
    for (const char* name : {group::input, group::fields, group::bricks, group::view, group::look}) {
        for (auto& [option, value] : line.settings(name)) {
            // A picture that is passed on should not tell where its maker keeps files.
            if (option == "reference" || option == "roi" || option == "mask")
                value = std::filesystem::path(value).filename().string();
            metadata.emplace_back(option, std::move(value));
        }
    }
    metadata.emplace_back("frames", fmt::to_string(report.frames));
    metadata.emplace_back("damaged", fmt::to_string(report.damaged));
    metadata.emplace_back("frames-a-layer", fmt::to_string(report.step));
    metadata.emplace_back("layers", fmt::to_string(report.layers));
    metadata.emplace_back("renderer", report.renderer);
    return metadata;
}

void log_report(const RenderReport& report, spdlog::logger& log) {
    const std::string& name = report.info.name;
    log.debug("backend {}: {}", report.backend, report.renderer);
    log.debug("fields {}x{}, {} arrows", report.field_size.width, report.field_size.height, report.arrows);
    if (report.damaged > 0) {
        log.warn("'{}': {}; the picture shows {} that decoded", name, counted(report.damaged, "damaged packet"),
                 counted(report.frames, "frame"));
    }
    if (report.still) log.warn("'{}': nothing moves, so the volume is empty; --threshold sets what counts", name);
    if (report.step > 1)
        log.info("{} share a layer, as the clip is longer than the window", counted(report.step, "frame"));
}

RenderedClip render(const RenderSettings& settings, spdlog::logger& log) {
    const auto source = open_clip(settings.input, wants_colour(settings), settings.run.threads);
    const RenderJob job = job_for(settings, source->info());
    const Plan plan = make_plan(job, *source);
    check_memory(plan);
    Progress progress("frames", plan.frames, !settings.run.quiet && stderr_is_terminal());
    RenderedClip clip = render_clip(job, *source, [&](std::int64_t frames) { progress.set(frames); });
    progress.clear();
    log_report(clip.report, log);
    return clip;
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
    check(settings);
    check(output);
    {
        // What can fail without reading the clip fails now.
        const auto held = environment.signals.hold();
        check_picture_path(output.path);
    }
    const auto begin = std::chrono::steady_clock::now();
    const RenderedClip clip = render(settings, environment.log);
    {
        const auto held = environment.signals.hold();
        write_picture(output.path, clip.picture, describe(line, clip.report));
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    environment.log.info("'{}': {} in {} and {}, {:.1f} s", output.path.string(), counted(clip.report.frames, "frame"),
                         counted(clip.report.layers, "layer"),
                         counted(static_cast<std::int64_t>(clip.report.bricks.size()), "brick"), took.count());
    return ExitStatus::done;
}

}  // namespace vvr
