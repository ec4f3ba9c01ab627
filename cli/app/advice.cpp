#include "cli/app/advice.h"

#include <optional>

#include <fmt/format.h>

#include "core/events/scraps.h"
#include "core/store/manifest.h"

namespace vvr::app {

namespace {

/// Where the events are mostly pieces of one part of the scene.
std::optional<std::string> advice_on_clutter(const RenderJob& job, const RenderReport& report) {
    // Who names a region knows the option; what was extracted takes none.
    if (!report.events || !job.fields.roi.empty() || store::is_data_folder(job.input.names.front()))
        return std::nullopt;
    const std::optional<events::Clutter> scraps = events::find_clutter(*report.events, report.field_size);
    if (!scraps) return std::nullopt;
    const double x = static_cast<double>(report.info.size.width) / report.field_size.width;
    const double y = static_cast<double>(report.info.size.height) / report.field_size.height;
    const PixelBox& box = scraps->box;
    return fmt::format(
        "'{}': {} of {} events are small and keep to one place, most of them in {:.0f}x{:.0f} pixels at {:.0f},{:.0f}; "
        "if they tell you nothing, choose where to look with --roi; this makes a page to draw it on: vvr inspect '{}' "
        "--frame {:.1f}s -o roi.html",
        report.info.name, scraps->count, report.events->size(), box.width() * x, box.height() * y, box.left * x,
        box.top * y, report.info.name, scraps->at.seconds);
}

}  // namespace

std::vector<std::string> advice_on(const RenderJob& job, const RenderReport& report) {
    std::vector<std::string> advice;
    if (auto text = advice_on_clutter(job, report)) advice.push_back(std::move(*text));
    return advice;
}

}  // namespace vvr::app
