#include "cli/plan/input.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "cli/plan/look.h"
#include "core/base/error.h"
#include "core/base/setting.h"
#include "core/base/text.h"
#include "core/dataset/stored_fields.h"
#include "core/fields/filter.h"
#include "core/fields/flow.h"
#include "core/fields/seed_list.h"
#include "core/fields/seeds.h"
#include "core/footage/open_source.h"
#include "core/footage/recorder_names.h"
#include "core/footage/recording.h"
#include "core/footage/recording_source.h"
#include "core/media/input.h"

namespace vvr::app {

std::string shown_name(const std::string& input) {
    namespace fs = std::filesystem;
    if (input == "-") return "stdin";
    std::string path = input;
    if (media::is_url(input)) {
        path = input.substr(input.find("://") + 3);
        path.resize(std::min(path.size(), path.find_first_of("?#")));
        path = path.find('/') == std::string::npos ? "" : path.substr(path.find('/'));
    }
    const fs::path whole = fs::path(path).lexically_normal();
    const std::string name = (whole.has_filename() ? whole : whole.parent_path()).filename().string();
    return name.empty() || name == "/" || name == "." ? "a clip" : name;
}

std::string title_of(const std::string& asked, const media::VideoInfo& clip) {
    if (!asked.empty()) return asked;
    return clip.title.empty() ? shown_name(clip.name) : clip.title;
}

std::string camera_of(const RenderJob& job, const media::VideoInfo& info) {
    if (!job.output.page_camera.empty()) return job.output.page_camera;
    if (!job.input.camera.empty()) return job.input.camera;
    // Frames from memory have no file, and an extraction does not keep its clip's camera.
    if (job.input.names.empty() || dataset::is_data_folder(job.input.names.front())) return {};
    if (!info.segments.empty()) return info.title;
    return footage::segment_from_name(job.input.names.front(), footage::RecorderNames(job.input.name_patterns)).camera;
}

void report_warnings(const std::vector<std::string>& warnings, const std::vector<std::string>& problems,
                     Observer& observer) {
    constexpr std::size_t most_logged = 5;  // problems logged at most; a failing disk may cause thousands
    for (const std::string& warning : warnings) observer.warn(warning);
    const std::size_t shown =
        problems.size() == most_logged + 1 ? problems.size() : std::min(most_logged, problems.size());
    for (std::size_t i = 0; i < shown; ++i) observer.warn(problems[i]);
    if (shown == problems.size()) return;
    observer.warn(fmt::format("another {} could not be read completely; the report lists all of them (--report)",
                              counted(static_cast<std::int64_t>(problems.size() - shown), "file")));
}

void require_whole(const media::VideoInfo& info) {
    if (info.left_out.files == 0) return;
    throw Error(ErrorCode::partial,
                fmt::format("the result does not cover all of '{}': {}", info.name, footage::text_of(info.left_out)));
}

namespace {

// Settings that `vvr seeds` can change on a stored flow.
constexpr std::array settings_of_seeds{setting::grid.name, setting::min_magnitude.name, setting::seed_area.name,
                                       setting::seed_order.name, setting::seed_select.name};

/// Checks that the settings given agree with the extraction's.
void check_agreement(const RenderJob& job, const image::Metadata& extracted) {
    const std::string& folder = job.input.names.front();
    image::Metadata others;
    std::string list;
    for (const auto& [name, value] : job.given) {
        const auto found = std::ranges::find(extracted, name, &image::Metadata::value_type::first);
        std::string had = found == extracted.end() ? "none" : found->second;
        if (value == had) continue;
        list += fmt::format("{}{} {} (extracted: {})", list.empty() ? "" : ", ", name, value, had);
        others.emplace_back(name, std::move(had));
    }
    if (others.empty()) return;
    const bool of_seeds = std::ranges::all_of(others, [](const auto& other) {
        return std::ranges::find(settings_of_seeds, other.first) != settings_of_seeds.end();
    });
    const char* const command = of_seeds ? "seeds" : "extract";
    if (others.size() == 1) {
        throw Error(ErrorCode::extraction_unsuitable,
                    fmt::format("{} {}: '{}' was extracted with {}; remove this setting, or run `vvr {}` again with it",
                                others.front().first, image::value_of(job.given, others.front().first), folder,
                                others.front().second, command),
                    {others.front().first});
    }
    const std::string preset = image::value_of(job.settings, "preset");
    throw Error(
        ErrorCode::extraction_unsuitable,
        fmt::format(
            "'{}' was extracted with other settings: {}; remove these settings, or run `vvr {}{}` again with them",
            folder, list, command, preset.empty() ? "" : fmt::format(" --preset {}", preset)));
}

OpenedFields open_extracted(const RenderJob& job) {
    const fields::FilterRow* const second = job.look.colour->filter;
    if (second != nullptr) {
        throw Error(
            ErrorCode::extraction_unsuitable,
            fmt::format(
                "color {}: '{}' stores the values of one filter only; render the clip itself, or choose another color",
                second->name, job.input.names.front()),
            {setting::colour.name});
    }
    const std::vector<std::string>& folders = job.input.names;
    if (job.fields.span.asked != media::RequestedSpan{}) {
        throw Error(
            ErrorCode::extraction_unsuitable,
            fmt::format(
                "'{}' is an extraction, and only all of it can be drawn; extract the wanted part of the clip instead",
                folders.front()),
            {setting::start.name, setting::end.name, setting::between.name});
    }
    auto source = std::make_unique<dataset::StoredFields>(folders);
    image::Metadata settings = source->settings();
    check_agreement(job, settings);
    return {std::move(source), std::move(settings)};
}

OpenedFields open_any(const RenderJob& job) {
    require_input(job.input);
    if (!job.input.open && std::ranges::all_of(job.input.names, dataset::is_data_folder)) return open_extracted(job);
    OpenedFields opened;
    auto clip = open_clip(job.input, wants_colour(job), job.fields.threads, opened.warnings, job.bricks.max_layers);
    fields::FieldOptions fields = field_options_of(job);
    fields.span = resolve_span(fields.span, job.look.start_time, clip->info(), opened.day_times);
    clip->fit_size(fields.span.start);
    opened.span = fields.span;
    opened.source = std::make_unique<fields::ClipFields>(std::move(clip), std::move(fields));
    return opened;
}

}  // namespace

ClipFacts OpenedFields::facts() const {
    return {source->info(), source->field_size(), source->expected_frames(), extracted, warnings, span};
}

fields::FieldOptions field_options_of(const RenderJob& job) {
    fields::FieldOptions options = job.fields;
    options.second = job.look.colour->filter;
    return options;
}

bool wants_colour(const RenderJob& job) {
    const ColourRow& colour = *job.look.colour;
    // Objects are found by colour too; this must not depend on what the picture shows.
    return job.fields.filter->traits.colour || fields::needs_reference(field_options_of(job)) ||
           job.look.show.any(&PartRow::needs_pictures) || !job.detector.model.empty() || colour.needs_pictures ||
           (colour.filter != nullptr && colour.filter->traits.colour);
}

void require_input(const InputOptions& options) {
    if (options.names.empty()) {
        throw Error(ErrorCode::input_missing,
                    "no INPUT given; name video files, a folder of videos or pictures, or - for stdin");
    }
}

const std::string& only_input(const InputOptions& options) {
    require_input(options);
    if (options.names.size() > 1) {
        throw Error(ErrorCode::input_unsuitable,
                    fmt::format("only one INPUT is accepted; remove '{}'", options.names[1]));
    }
    return options.names.front();
}

std::unique_ptr<media::FrameSource> open_clip(const InputOptions& options, bool colour, int threads,
                                              std::vector<std::string>& warnings, std::int64_t layers) {
    require_input(options);
    warnings.insert(warnings.end(), options.problems.begin(), options.problems.end());
    media::SourceOptions source;
    source.field_size = options.field_size;
    source.colour = colour;
    source.threads = threads;
    source.rate = options.rate;
    source.track = options.track;
    source.aspect = options.aspect;
    source.join = options.join;
    source.decode = options.decode;
    source.hwaccel = options.hwaccel;
    source.layers = layers;
    if (options.open) return options.open(source);
    return footage::open_sources(options.names, source, footage::RecorderNames(options.name_patterns), warnings);
}

media::FrameSpan resolve_span(const media::FrameSpan& span, const StartTime& start, const media::VideoInfo& info,
                              std::string& day_times) {
    const WallClock clock = clock_of(start, info);
    media::FrameSpan resolved = media::resolve(span, clock, info);
    const std::string times = media::day_times_of(resolved, clock, info);
    if (!times.empty()) {
        const bool counted = span.asked == media::RequestedSpan{};
        day_times = fmt::format(
            "'{}': {}{}", info.name, times,
            counted ? "; --start and --end count from the first frame; for a time of day, write @02:00" : "");
    }
    return resolved;
}

std::unique_ptr<fields::FieldSource> with_listed_seeds(std::unique_ptr<fields::FieldSource> fields,
                                                       const RenderJob& job, const fields::FilterRow& filter,
                                                       bool compares) {
    if (job.seeds.empty()) return fields;
    const fields::SeedOptions& seeds = job.fields.seeds;
    const bool on_object = filter.traits.shows_object && seeds.area->object_alone;
    return std::make_unique<fields::ListedSeeds>(std::move(fields), job.seeds, seeds, on_object, compares);
}

void check_has_end(const media::VideoInfo& info, Observer& observer) {
    if (!media::is_url(info.name) || info.frames > 0 || info.duration > 0) return;
    const std::string protocol = info.name.substr(0, info.name.find(':'));
    // With these protocols, a finite file may have no known length.
    constexpr std::array<std::string_view, 4> of_files{"http", "https", "ftp", "sftp"};
    if (std::ranges::find(of_files, protocol) == of_files.end()) {
        throw Error(ErrorCode::input_unsuitable,
                    fmt::format("'{}' is a live stream without an end; draw it with `vvr watch`, or record a part of "
                                "it first: ffmpeg -i ADDRESS -t 60 -c copy part.mkv",
                                info.name));
    }
    observer.warn(fmt::format(
        "'{}' does not state its length, and is read to its end; if it is a live stream, use `vvr watch` instead",
        info.name));
}

OpenedFields open_fields(const RenderJob& job) {
    OpenedFields opened = open_any(job);
    const std::string filter = image::value_of(opened.extracted, setting::filter.name);
    const Choice<fields::FilterRow> of_fields = filter.empty() ? job.fields.filter : Choice<fields::FilterRow>(filter);
    // A stored flow may have been replaced after the lists were made.
    const std::string flow = image::value_of(opened.extracted, setting::flow.name);
    const bool compares = !flow.empty() && flow != fields::no_flow().name;
    opened.source = with_listed_seeds(std::move(opened.source), job, *of_fields, compares);
    return opened;
}

}  // namespace vvr::app
