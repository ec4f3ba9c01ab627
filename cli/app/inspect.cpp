#include "cli/app/inspect.h"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "cli/app/find_frame.h"
#include "cli/app/inspection.h"
#include "cli/app/open_fields.h"
#include "cli/app/shown_name.h"
#include "cli/app/tell_problems.h"
#include "core/base/error.h"
#include "core/fields/pipeline.h"
#include "core/fields/region.h"
#include "core/fields/settings.h"
#include "core/image/atomic_file.h"
#include "core/image/picture_file.h"
#include "core/image/text.h"
#include "core/labels/time_ticks.h"
#include "core/page/region_editor.h"
#include "core/video/scaler.h"

namespace vvr::app {

namespace {

/// The frame in the size and the colours of the clip.
Plane<Bgr> picture_of(video::FrameSource& clip, const Moment& moment) {
    clip.seek(moment.seconds - 1);
    video::Scaler scale(clip);
    while (const auto frame = clip.next()) {
        if (frame->index >= moment.frame) return video::picture_of(scale(*frame));
    }
    throw Error(ErrorKind::not_video, fmt::format("'{}': frame {} does not decode any more; has the file changed?",
                                                  clip.info().name, moment.frame));
}

/// Regions as polygons; a page can't change a picture.
std::string polygons_of(std::string_view setting, const std::string& area, Observer& observer) {
    std::string list = fields::polygon_list(setting, area);
    if (area.empty() || !list.empty()) return list;
    observer.warn(fmt::format("{} '{}' is a picture, so the page begins without it", setting, area), {setting});
    return {};
}

/// The frame that was asked for; else the one in the middle, but not so far in that finding it takes long.
Time wanted_frame(const InspectJob& job, const video::VideoInfo& info) {
    constexpr double farthest = 60;
    return job.frame.value_or(Time{std::min(info.duration / 2, farthest), Time::Unit::seconds});
}

/// What is to be said where nobody chose the frame.
std::string_view about_choice(const InspectJob& job) {
    return job.frame ? "" : "; --frame TIME chooses another";
}

void write_region_editor(const InspectJob& job, Observer& observer) {
    InputOptions options = job.input;
    options.field_size = {-1, -1};
    page::RegionEditorContent content;
    content.roi = polygons_of(setting::roi.name, job.fields.roi, observer);
    content.mask = polygons_of(setting::mask.name, job.fields.mask, observer);
    std::vector<std::string> warnings;
    const auto clip = open_clip(options, true, job.fields.threads, warnings);
    report_warnings(warnings, {}, observer);
    const Moment found = find_frame(*clip, wanted_frame(job, clip->info()));
    content.name = shown_name(clip->info().name);
    content.moment = labels::format_moment(found.seconds);
    content.frame = picture_of(*clip, found);
    const std::string text = page::make_region_editor(content);
    const auto held = observer.guard();
    image::replace_file(job.path, std::as_bytes(std::span(text)));
    observer.info(fmt::format("'{}': draw regions on frame {} at {:.3f} s, and copy the option for them{}",
                              job.path.string(), found.frame, found.seconds, about_choice(job)));
}

}  // namespace

void inspect(const InspectJob& job, Observer& observer) {
    if (is_page(job.path)) return write_region_editor(job, observer);
    image::choose_font(job.font);
    constexpr bool colour = true;
    std::vector<std::string> warnings;
    const auto clip = open_clip(job.input, colour, job.fields.threads, warnings);
    const Moment found = find_frame(*clip, wanted_frame(job, clip->info()));
    // The other frames only serve as neighbours.
    fields::FieldOptions fields = job.fields;
    fields.span.first = found.frame;
    fields.span.stop = found.frame + 1;
    Inspection inspection;
    const fields::FieldSummary summary =
        fields::compute_fields(*clip, fields, [&](const video::SharedFrame& frame, const fields::Field& field) {
            if (field.index == found.frame) inspection = inspect(*frame, field);
        });
    report_warnings(warnings, summary.problems, observer);
    const std::string name = job.path.string();
    if (!inspection.captions) {
        observer.warn(
            fmt::format("fontconfig finds no font, so '{}' has no captions; install one, for example "
                        "fonts-dejavu-core",
                        name));
    }
    const auto held = observer.guard();
    image::write_picture(job.path, inspection.picture);
    observer.info(fmt::format("'{}': frame {} at {:.3f} s{}", name, found.frame, found.seconds, about_choice(job)));
}

}  // namespace vvr::app
