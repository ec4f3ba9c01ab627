#include "cli/app/record.h"

#include <algorithm>

#include <fmt/format.h>

#include "cli/app/settings.h"
#include "cli/app/used_settings.h"
#include "core/image/text.h"

namespace vvr::app {

void put(image::Metadata& settings, std::string_view name, const std::string& value) {
    const auto known = std::ranges::find(settings, name, &image::Metadata::value_type::first);
    if (known == settings.end()) {
        settings.emplace_back(name, value);
    } else {
        known->second = value;
    }
}

std::string value_of(const image::Metadata& settings, std::string_view name) {
    const auto found = std::ranges::find(settings, name, &image::Metadata::value_type::first);
    return found == settings.end() ? "" : found->second;
}

image::Metadata settings_and_font(const RenderJob& job, const RenderReport& report) {
    image::Metadata settings = used_settings(job.settings);
    const bool text = !report.lettering.labels.empty() || !report.lettering.badges.empty();
    if (text) put(settings, setting::font.name, image::font_name());
    return settings;
}

image::Metadata record_of(const RenderJob& job, const RenderReport& report, bool series) {
    image::Metadata record = settings_and_font(job, report);
    record.emplace_back("frames", fmt::to_string(report.frames));
    if (series) {
        // Damage is only known at the end of the clip.
        record.emplace_back("first-frame", fmt::to_string(report.first_frame));
        record.emplace_back("seconds", fmt::format("{:.3f} to {:.3f}", report.first_pts, report.last_pts));
    } else {
        record.emplace_back("damaged", fmt::to_string(report.damaged));
    }
    record.emplace_back("frames-per-layer", fmt::to_string(report.step));
    record.emplace_back("layers-drawn", fmt::to_string(report.layers));
    record.emplace_back("renderer", report.renderer);
    return record;
}

}  // namespace vvr::app
