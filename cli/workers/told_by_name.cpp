#include "cli/workers/told_by_name.h"

#include <fmt/format.h>

#include "core/archive/names.h"
#include "core/base/clock_source.h"
#include "core/base/local_time.h"
#include "core/base/shown_text.h"
#include "core/labels/time_ticks.h"

namespace vvr::workers {

std::string describe_name(const std::string& clip, const video::RecorderNames& names) {
    const video::RecorderName name = names.read(clip);
    const std::string camera = names.camera_of(clip);
    std::string text = camera.empty() ? "camera not known" : "camera " + shown_text(archive::text_of_path(camera));
    if (!name.begin) return fmt::format("{}, {}", text, row_of(ClockSource::none).words);
    const std::int64_t utc = video::utc_of(*name.begin);
    return fmt::format("{}, {} {} ({})", text, labels::format_clock(utc + local_offset(utc)),
                       row_of(ClockSource::file_name).words, name.layout);
}

}  // namespace vvr::workers
