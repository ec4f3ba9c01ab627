#include "cli/app/render.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "cli/app/golden.h"
#include "cli/app/input.h"
#include "cli/app/plan.h"
#include "cli/app/record.h"
#include "cli/app/render_series.h"
#include "cli/app/report.h"
#include "cli/app/write.h"
#include "core/base/error.h"
#include "core/base/file_io.h"
#include "core/base/text.h"
#include "core/image/atomic_file.h"
#include "core/image/text.h"
#include "core/page/stills.h"

namespace vvr::app {

namespace {

void show_warnings(const RenderJob& job, const RenderReport& report, Observer& observer) {
    const std::string& name = report.info.name;
    observer.debug(fmt::format("backend {}: {}", report.backend, report.renderer));
    observer.debug(
        fmt::format("fields {}x{}, {} arrows", report.field_size.width, report.field_size.height, report.arrows));
    if (report.damaged > 0) {
        observer.warn(fmt::format("'{}': {}; shown are {} that decoded", name,
                                  counted(report.damaged, "damaged packet"), counted(report.frames, "frame")));
    }
    if (report.frames_missing) {
        observer.warn(
            fmt::format("'{}' holds only the clip's first and last picture; no other frames are shown", name));
    }
    if (!is_series(job.output) && report.keyframes < static_cast<std::size_t>(job.look.keyframes)) {
        observer.warn(
            fmt::format("'{}': only {} of {} are shown; the clip's header does not say how long it is, or it "
                        "is shorter",
                        name, report.keyframes, counted(job.look.keyframes, "key frame")));
    }
    if (report.lettering.font_missing) {
        observer.warn(
            "fontconfig finds no font, so the picture has no text; install one, for example fonts-dejavu-core");
    }
    if (report.still && report.frames < 2) {
        observer.warn(fmt::format("'{}': there is one frame, so nothing can move, and the volume is empty", name));
    } else if (report.still) {
        observer.warn(fmt::format("'{}': nothing moves, so the volume is empty; a lower threshold shows more", name),
                      {"threshold"});
    }
    for (const std::string& advice : report.advice) observer.warn(advice);
    if (!report.squeezed.empty()) {
        double idle = 0;
        for (const bricks::CompressedIdle& stretch : report.squeezed) idle += stretch.seconds;
        observer.info(
            fmt::format("room along the arc goes where something moves: {} without motion are drawn short, in {}",
                        labels::format_duration(idle), counted(std::ssize(report.squeezed), "place")));
    } else if (report.step > 1) {
        observer.info(
            fmt::format("{} share a layer, as the clip is longer than the window", counted(report.step, "frame")));
    }
}

/// What came of the run, in a line.
std::string outcome(const RenderJob& job, bool series, const RenderReport& report) {
    const std::string name = job.output.path.empty() ? report.info.name : job.output.path.string();
    const std::string frames = counted(report.frames, "frame");
    if (series) return fmt::format("'{}': {} of {}", name, counted(report.pictures, "picture"), frames);
    return fmt::format("'{}': {} in {} and {}", name, frames, counted(report.layers, "layer"),
                       counted(std::ssize(report.bricks), "brick"));
}

/// Sees the fields on their way, to keep what a page and a still show of them.
page::WatchedFields* watch(const OutputOptions& output, OpenedFields& fields) {
    if (page_of(output).empty() && output.still.empty()) return nullptr;
    auto watched = std::make_unique<page::WatchedFields>(std::move(fields.source), !page_of(output).empty());
    page::WatchedFields* const watcher = watched.get();
    fields.source = std::move(watched);
    return watcher;
}

std::span<const events::Event> events_of(const RenderReport& report) {
    return report.events ? std::span<const events::Event>(*report.events) : std::span<const events::Event>();
}

}  // namespace

RenderReport render(const RenderJob& given, Observer& observer, const DrawnSink& taken) {
    validate(given);
    image::choose_font(given.look.font);
    const RenderJob asked = with_fields_of_colour(given);
    const auto begin = std::chrono::steady_clock::now();
    PictureOutput pictures(asked.output, observer);
    check_golden_picture(asked.output.golden);
    OpenedFields fields = open_fields(asked);
    check_has_end(fields.source->info(), observer);
    RenderJob job = with_colour(with_transfer(with_possible_parts(with_extracted(asked, fields.extracted))));
    if (fields.extracted.empty()) job.fields.span = fields.span;
    if (!fields.day_times.empty()) observer.info(fields.day_times);
    Products products = products_of(job);
    if (taken) products.pictures = std::max(products.pictures, 1);
    const std::filesystem::path& page = page_of(job.output);
    page::WatchedFields* const watched = watch(job.output, fields);
    check_memory(make_plan(job, products, *fields.source));

    image::Picture drawn;
    const PictureSink write = [&](const RenderReport& report, int number, image::Picture&& picture) {
        const image::Metadata record = record_of(job, report, products.series);
        if (taken) taken(picture, record);
        if (!job.output.golden.path.empty()) drawn = {picture.pixels};
        pictures.add_thumbnail(picture);
        page::Moments moments = watched == nullptr ? page::Moments{} : watched->take();
        if (!moments.problem.empty()) {
            observer.warn(fmt::format("the page has stills and no preview, as libav made none: {}", moments.problem));
        }
        pictures.add_still(page::best_still(moments.stills, events_of(report), report.field_size));
        if (page.empty()) {
            pictures.add(number, std::move(picture), record);
            return;
        }
        if (!is_page(job.output.path)) pictures.add(number, picture, record);
        pictures.add_page(page_text(job, report, std::move(picture), record, std::move(moments)));
    };
    RenderReport report = products.series ? render_series(job, products, *fields.source, observer, write)
                                          : render_clip(job, products, *fields.source, observer, write);
    if (report.frames == 0) {
        throw Error(ErrorKind::not_video,
                    fmt::format("'{}' gives no frame any more; was it changed or removed while it was read?",
                                fields.source->info().name));
    }
    report_warnings(fields.warnings, report.problems, observer);
    report.problems.insert(report.problems.begin(), fields.warnings.begin(), fields.warnings.end());
    show_warnings(job, report, observer);
    pictures.close();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    observer.info(fmt::format("{}, {:.1f} s", outcome(job, products.series, report), took.count()));
    if (products.events && report.events) observer.info(summary_of(*report.events, report.clock));
    if (!job.output.report.empty()) {
        const std::string text = format_report(report, settings_and_font(job, report), took.count());
        const auto bytes = std::as_bytes(std::span(text));
        const auto held = observer.guard();
        if (is_standard_output(job.output.report)) {
            write_standard_output(bytes);
        } else {
            image::replace_file(job.output.report, bytes);
        }
    }
    if (!job.output.golden.path.empty()) {
        compare_with_golden(job.output.golden, drawn, record_of(job, report, products.series), observer);
    }
    return report;
}

}  // namespace vvr::app
