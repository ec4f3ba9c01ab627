#include "cli/app/extract.h"

#include <chrono>

#include <fmt/format.h>

#include "cli/app/input.h"
#include "cli/app/settings.h"
#include "cli/app/used_settings.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fields/field_source.h"
#include "core/fields/flow.h"
#include "core/store/extraction.h"

namespace vvr::app {

namespace {

/// Converts the part's number to a span of frames. The last part has no end, as the header's length can be wrong.
void choose_part(ExtractJob& job, const video::VideoInfo& clip) {
    if (!job.part) return;
    if (job.fields.span != video::FrameSpan{}) {
        throw Error(ErrorCode::options_conflict, "part says where to begin and to end; leave out the start and the end",
                    {"part", setting::start.name, setting::end.name});
    }
    const auto [part, count] = *job.part;
    if (clip.frames < count) {
        throw Error(
            ErrorCode::option_value_out_of_range,
            fmt::format("part {}/{}: '{}' has {}; ask for fewer parts, or give the start and the end", part, count,
                        clip.name, clip.frames > 0 ? counted(clip.frames, "frame") : "a header without a length"),
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

}  // namespace

void extract(ExtractJob job, Observer& observer) {
    store::check_data_folder(job.folder);
    const auto begin = std::chrono::steady_clock::now();
    constexpr bool colour = true;
    std::vector<std::string> warnings;
    const auto clip = open_clip(job.input, colour, job.fields.threads, warnings);
    std::string day_times;
    job.fields.span = resolve_span(job.fields.span, job.start_time, clip->info(), day_times);
    if (!job.fields.span.parts.empty()) {
        throw Error(ErrorCode::options_conflict,
                    fmt::format("between: '{}' has {} of it, and an extraction is of one stretch; give --start and "
                                "--end as well, with dates",
                                clip->info().name, counted(std::ssize(job.fields.span.parts), "part")),
                    {setting::between.name});
    }
    if (!day_times.empty()) observer.info(day_times);
    choose_part(job, clip->info());
    check_has_end(clip->info(), observer);
    const std::int64_t expected = video::expected_frames(clip->info(), job.fields.span);
    const std::int64_t flow_every = fields::has_flow(job.fields.flow) ? job.fields.flow.every : 0;
    std::optional<store::DataFolder> folder;
    std::int64_t frames = 0;
    const fields::FieldSummary summary =
        fields::compute_fields(*clip, job.fields, [&](const video::SharedFrame& frame, fields::Field&& field) {
            // Create the folder only now, so that an older extraction stays if this one fails early.
            if (!folder) folder.emplace(job.folder, flow_every, job.colour);
            folder->add(*frame, field);
            observer.frames(++frames, expected);
        });
    require_frames(summary.frames, clip->info());
    store::Manifest manifest;
    manifest.clip = clip->info();
    manifest.clip.title = title_of("", clip->info());
    manifest.span = job.fields.span;
    manifest.field_size = clip->field_size();
    manifest.damaged = summary.damaged;
    manifest.settings = used_settings(job.settings);
    {
        const auto held = observer.guard();
        folder->close(std::move(manifest), summary.reference);
    }
    report_warnings(warnings, summary.problems, observer);
    if (summary.damaged > 0) {
        observer.warn(
            fmt::format("'{}': {} of what was read", clip->info().name, counted(summary.damaged, "damaged packet")));
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    observer.info(fmt::format("'{}': {} of {}x{}, {:.1f} s", job.folder.string(), counted(summary.frames, "frame"),
                              clip->field_size().width, clip->field_size().height, took.count()));
    require_whole(clip->info());
}

}  // namespace vvr::app
