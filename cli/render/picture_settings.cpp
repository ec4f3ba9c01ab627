#include "cli/render/picture_settings.h"

#include <fmt/format.h>

#include "cli/render/open_fields.h"
#include "cli/options/option.h"

namespace vvr {

Metadata settings_of(const CommandLine& line, const Metadata& extracted) {
    Metadata metadata;
    for (const char* name : {group::input, group::fields, group::bricks, group::view, group::look}) {
        for (const auto& [option, value] : line.settings(name, extracted)) {
            metadata.emplace_back(option, without_folder(option, value));
        }
    }
    return metadata;
}

Metadata describe(const CommandLine& line, const Metadata& extracted, const RenderReport& report, bool series) {
    Metadata metadata = settings_of(line, extracted);
    metadata.emplace_back("frames", fmt::to_string(report.frames));
    if (series) {
        // Damage is only known at the end of the clip.
        metadata.emplace_back("first-frame", fmt::to_string(report.first_frame));
        metadata.emplace_back("seconds", fmt::format("{:.3f} to {:.3f}", report.first_pts, report.last_pts));
    } else {
        metadata.emplace_back("damaged", fmt::to_string(report.damaged));
    }
    metadata.emplace_back("frames-a-layer", fmt::to_string(report.step));
    metadata.emplace_back("layers", fmt::to_string(report.layers));
    metadata.emplace_back("renderer", report.renderer);
    return metadata;
}

}  // namespace vvr
