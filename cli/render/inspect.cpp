#include "cli/render/inspect.h"

#include <fmt/format.h>

#include "cli/render/find_frame.h"
#include "cli/render/inspection.h"
#include "cli/render/open_fields.h"
#include "cli/render/tell_problems.h"
#include "core/fields/pipeline.h"
#include "core/image/picture_file.h"

namespace vvr {

void inspect(const InspectJob& job, Observer& observer) {
    constexpr bool colour = true;
    std::vector<std::string> warnings;
    const auto clip = open_clip(job.input, colour, job.fields.threads, warnings);
    const Moment found = find_frame(*clip, job.frame);
    // The other frames only serve as neighbours.
    FieldOptions fields = job.fields;
    fields.span.first = found.frame;
    fields.span.stop = found.frame + 1;
    Inspection inspection;
    const FieldSummary summary = compute_fields(*clip, fields, [&](const SharedFrame& frame, const Field& field) {
        if (field.index == found.frame) inspection = inspect(*frame, field);
    });
    tell_problems(warnings, summary.problems, observer);
    const std::string name = job.path.string();
    if (!inspection.captions) {
        observer.warn(
            fmt::format("fontconfig finds no font, so '{}' has no captions; install one, for example "
                        "fonts-dejavu-core",
                        name));
    }
    const auto held = observer.guard();
    write_picture(job.path, inspection.picture);
    observer.info(fmt::format("'{}': frame {} at {:.3f} s", name, found.frame, found.seconds));
}

}  // namespace vvr
