#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/observe/observe.h"
#include "cli/options/command_line.h"
#include "cli/options/job_options.h"
#include "cli/plan/input.h"
#include "cli/plan/observer.h"
#include "cli/plan/settings.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/dataset/data_folder.h"
#include "core/fields/field_source.h"
#include "core/fields/flow.h"
#include "core/tracking/overlay.h"

namespace vvr::commands {

namespace {

/// A clip, and the folder for its data files.
struct ExtractJob {
    app::InputOptions input;
    fields::FieldOptions fields;  ///< flow and seeds are stored every `fields.flow.every` frames
    app::StartTime start_time;    ///< for a `fields.span` given in wall-clock times
    std::filesystem::path folder;
    std::optional<std::pair<int, int>> part;  ///< part I of N as {I, N}, from 1; none = use fields.span
    image::Metadata settings;                 ///< all settings as text, for the manifest
};

/// Converts the part's number to a span of frames. The last part has no end, as the header's length can be wrong.
void choose_part(ExtractJob& job, const media::VideoInfo& clip) {
    if (!job.part) return;
    if (job.fields.span != media::FrameSpan{}) {
        throw Error(ErrorCode::options_conflict, "part selects the frames already; remove the start and the end",
                    {"part", setting::start.name, setting::end.name});
    }
    const auto [part, count] = *job.part;
    if (clip.frames < count) {
        throw Error(
            ErrorCode::option_value_out_of_range,
            fmt::format("part {}/{}: '{}' has {}; choose fewer parts, or give the start and the end", part, count,
                        clip.name, clip.frames > 0 ? counted(clip.frames, "frame") : "no length in its header"),
            {"part", setting::start.name, setting::end.name});
    }
    const auto begin = [&, count = count](int number) { return clip.frames * number / count; };
    job.fields.span.first = begin(part - 1);
    const std::int64_t first = job.fields.span.first;
    image::put(job.settings, setting::start.name,
               first == 0 ? std::string(setting::start.default_text) : fmt::format("{}f", first));
    if (part == count) return;
    job.fields.span.stop = begin(part);
    image::put(job.settings, setting::end.name, fmt::format("{}f", *job.fields.span.stop));
}

/// Writes the data files of Fig. 3: scalar fields, flow, seeds. Replaces an older extraction in the folder.
/// \throws Error usage, io, not_video, limit
void extract(ExtractJob job, app::Observer& observer) {
    dataset::check_data_folder(job.folder);
    const auto begin = std::chrono::steady_clock::now();
    constexpr bool colour = true;
    std::vector<std::string> warnings;
    const auto clip = app::open_clip(job.input, colour, job.fields.threads, warnings);
    std::string day_times;
    job.fields.span = app::resolve_span(job.fields.span, job.start_time, clip->info(), day_times);
    if (!job.fields.span.parts.empty()) {
        throw Error(ErrorCode::options_conflict,
                    fmt::format("between: '{}' has {} of that time of day, but an extraction needs exactly one; add "
                                "--start and --end with dates",
                                clip->info().name, counted(std::ssize(job.fields.span.parts), "part")),
                    {setting::between.name});
    }
    if (!day_times.empty()) observer.info(day_times);
    choose_part(job, clip->info());
    app::check_has_end(clip->info(), observer);
    // Parts must make the picture that the whole clip makes; the picture leaves the clock out.
    if (job.fields.filter->traits.object && !job.part) job.fields.overlays = tracking::find_clocks(*clip);
    for (const PixelBox& box : job.fields.overlays) {
        observer.info(fmt::format("the fields leave out the camera's clock, {}x{} at {},{} of the field", box.width(),
                                  box.height(), box.left, box.top));
    }
    const std::int64_t expected = media::expected_frames(clip->info(), job.fields.span);
    const std::int64_t flow_every = fields::has_flow(job.fields.flow) ? job.fields.flow.every : 0;
    std::optional<dataset::DataFolder> folder;
    std::int64_t frames = 0;
    const fields::FieldSummary summary =
        fields::compute_fields(*clip, job.fields, [&](const media::SharedFrame& frame, fields::Field&& field) {
            // Create the folder only now, so that an older extraction stays if this one fails early.
            if (!folder) folder.emplace(job.folder, flow_every);
            folder->add(*frame, field);
            observer.frames(++frames, expected);
        });
    app::require_frames(summary.frames, clip->info());
    dataset::Manifest manifest;
    manifest.clip = clip->info();
    manifest.clip.title = app::title_of("", clip->info());
    manifest.span = job.fields.span;
    manifest.field_size = clip->field_size();
    manifest.damaged = summary.damaged;
    manifest.settings = job.settings;
    {
        const auto held = observer.guard();
        folder->close(std::move(manifest), summary.reference);
    }
    app::report_warnings(warnings, summary.problems, observer);
    if (summary.damaged > 0) {
        observer.warn(fmt::format("'{}': {} could not be decoded", clip->info().name,
                                  counted(summary.damaged, "damaged packet")));
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    observer.info(fmt::format("'{}': {} of {}x{}, {:.1f} s", job.folder.string(), counted(summary.frames, "frame"),
                              clip->field_size().width, clip->field_size().height, took.count()));
    app::require_whole(clip->info());
}

namespace extract_text {
constexpr Setting output{"output", "DIR", "a new or empty folder; an older extraction in it is replaced"};
constexpr Setting part{"part", "I/N", "extract only part I of N of the clip, 1/N to N/N"};
}  // namespace extract_text

class Extract final : public Command {
  public:
    void add_options(options::CommandLine& line) override {
        const options::AddOptions add(line, options::Group::output);
        add(extract_text::output, job_.folder, {.letter = 'o', .use = options::FileUse::written});
        // Not in Group::fields: it decides what is stored, not how a field is computed.
        add(setting::flow_every, job_.fields.flow.every);
        // The recorded settings have the part as --start and --end.
        add(extract_text::part, job_.part);
        options::add_recording_options(line, job_.input, options::clip_input);
        options::add_span_options(line, job_.fields.span);
        options::add_field_options(line, job_.fields);
        options::add_preset_option(line, options::Group::run);
        options::AddOptions(line, options::Group::look)(setting::start_time, job_.start_time);
        options::add_thread_options(line, job_.fields.threads);
        line.examples({{"vvr extract clip.avi -o data", "fields, flow and seeds as files"},
                       {"vvr render data -o data.png", "the picture of them"},
                       {"vvr extract clip.avi -o part --part 2/8", "one of eight parts of a long clip"}});
    }

    cli::ExitStatus run(const options::CommandLine& line, const cli::Environment& environment) override {
        if (job_.folder.empty())
            throw Error(ErrorCode::output_missing, "no output given; name the folder for the files with -o DIR");
        app::require_input(job_.input);
        job_.settings = options::record_of_fields(line);
        cli::Console console(environment);
        extract(job_, console);
        return cli::ExitStatus::done;
    }

  private:
    ExtractJob job_;
};

}  // namespace

std::unique_ptr<Command> make_extract() {
    return std::make_unique<Extract>();
}

}  // namespace vvr::commands
