#include "cli/app/clip_list.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/base/wall_clock.h"
#include "core/labels/time_ticks.h"
#include "core/store/manifest.h"
#include "core/video/recorder_names.h"

namespace vvr::app {

std::vector<video::Segment> list_clips(const InputOptions& options) {
    if (std::ranges::all_of(options.names, store::is_data_folder)) return {};
    const video::RecorderNames layouts(options.name_patterns);
    if (auto recording = video::find_recording(options.names, layouts, options.join))
        return std::move(recording->segments);
    std::error_code none;
    if (!std::filesystem::is_regular_file(options.names.front(), none)) return {};
    return {video::segment_from_name(options.names.front(), layouts)};
}

std::string text_of(const video::Segment& clip) {
    const std::string camera = clip.camera.empty() ? "camera not known" : "camera " + shown_text(clip.camera);
    const std::string_view by = row_of(clip.begin_source).words;
    if (!clip.begin) return fmt::format("{}, {}", camera, by);
    const bool named = clip.begin_source == ClockSource::file_name;
    return fmt::format("{}, {} UTC {}{}", camera, labels::format_clock(*clip.begin), by,
                       named ? fmt::format(" ({})", clip.layout) : "");
}

}  // namespace vvr::app
