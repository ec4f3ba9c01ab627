#include "cli/render/open_fields.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "cli/render/settings.h"
#include "core/choice.h"
#include "core/error.h"
#include "core/fields/filter.h"
#include "core/fields/listed_seeds.h"
#include "core/fields/seeds.h"
#include "core/store/stored_fields.h"
#include "core/video/recorder_names.h"

namespace vvr {

namespace {

// What `vvr seeds` can do again on a stored flow.
constexpr std::array settings_of_seeds{setting::grid.name, setting::min_magnitude.name, setting::seed_area.name,
                                       setting::seed_order.name, setting::seed_select.name};

OpenedFields open_extracted(const RenderJob& job) {
    if (!job.fields.second.empty()) {
        throw Error(
            ErrorKind::usage,
            fmt::format("color {}: '{}' holds the values of one filter; render the clip itself, or choose another "
                        "colour",
                        job.fields.second, job.input.names.front()),
            {setting::colour.name});
    }
    const std::vector<std::string>& folders = job.input.names;
    auto source = std::make_unique<StoredFields>(folders);
    for (const auto& [name, value] : job.given) {
        const auto found = std::ranges::find(source->settings(), name, &Metadata::value_type::first);
        const std::string extracted = found == source->settings().end() ? "" : found->second;
        if (value == extracted) continue;
        const bool of_seeds = std::ranges::find(settings_of_seeds, name) != settings_of_seeds.end();
        throw Error(
            ErrorKind::usage,
            fmt::format("{} {}: '{}' was extracted with {}; leave it out, or run `vvr {}` with it", name, value,
                        folders.front(), extracted.empty() ? "none" : extracted, of_seeds ? "seeds" : "extract"),
            {name});
    }
    Metadata settings = source->settings();
    return {std::move(source), std::move(settings)};
}

OpenedFields open_any(const RenderJob& job) {
    require_input(job.input);
    if (std::ranges::all_of(job.input.names, is_data_folder)) return open_extracted(job);
    OpenedFields opened;
    auto clip = open_clip(job.input, wants_colour(job), job.fields.threads, opened.warnings);
    opened.source = std::make_unique<ClipFields>(std::move(clip), job.fields);
    return opened;
}

}  // namespace

void require_input(const InputOptions& options) {
    if (options.names.empty()) {
        throw Error(ErrorKind::usage, "no INPUT: give video files, a folder of them or of pictures, or - for stdin");
    }
}

const std::string& only_input(const InputOptions& options) {
    require_input(options);
    if (options.names.size() > 1) {
        throw Error(ErrorKind::usage, fmt::format("'{}' is one argument too many: this takes one", options.names[1]));
    }
    return options.names.front();
}

std::unique_ptr<FrameSource> open_clip(const InputOptions& options, bool colour, int threads,
                                       std::vector<std::string>& warnings) {
    require_input(options);
    SourceOptions source;
    source.field_size = options.field_size;
    source.colour = colour;
    source.threads = threads;
    source.rate = options.rate;
    return open_sources(options.names, source, RecorderNames(options.layouts), warnings);
}

std::unique_ptr<FieldSource> with_listed_seeds(std::unique_ptr<FieldSource> fields, const RenderJob& job,
                                               std::string_view filter) {
    if (job.seeds.empty()) return fields;
    const SeedOptions& seeds = job.fields.seeds;
    const bool on_object = find_filter(filter).traits.shows_object &&
                           choose(setting::seed_area.name, seeds.area, seed_areas()).object_alone;
    return std::make_unique<ListedSeeds>(std::move(fields), job.seeds, seeds, on_object);
}

OpenedFields open_fields(const RenderJob& job) {
    OpenedFields opened = open_any(job);
    const std::string filter = with_extracted(job, opened.extracted).fields.filter;
    opened.source = with_listed_seeds(std::move(opened.source), job, filter);
    return opened;
}

}  // namespace vvr
