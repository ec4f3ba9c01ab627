#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/options/command_line.h"
#include "cli/options/job_options.h"
#include "cli/plan/settings.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/setting.h"
#include "core/image/name_pattern.h"
#include "core/image/picture_file.h"
#include "core/image/video_encoder.h"

namespace vvr::options {

namespace {

namespace rows {
constexpr Setting output{"output", "FILE", "the picture"};
constexpr Setting page{"page", "FILE", "a page to watch the clip from, beside the picture: .html"};
constexpr Setting flat_page{"flat-page", "", "a page whose picture cannot be turned, smaller by up to 350 kB"};
constexpr Setting still{"still", "FILE", "the most informative frame of the clip: .jpg .png"};
constexpr Setting report{
    "report", "FILE",
    "a JSON file with the input, the settings, the events and the run; needs no -o; - = standard output"};
constexpr Setting events_csv{"events-csv", "FILE",
                             "the events as a table with commas, one line per event; needs no -o"};
constexpr Setting tracks{"tracks", "FILE",
                         "the events' bounding boxes per frame, in the format of MOT Challenge; needs no -o"};
constexpr Setting events_to{
    "events-to", "FILE",
    "append a line of JSON for each event when it has ended, for other programs; a file, a named pipe, or - = "
    "standard output"};
constexpr Setting golden{
    "golden", "FILE",
    "compare the picture with this one; if they differ, exit with 7 and keep the new picture beside it"};
constexpr Setting diff{"diff", "FILE",
                       "picture of the differences: yellow = small, red = larger, black = the full range"};
}  // namespace rows

void check_standard_output(const app::OutputOptions& options) {
    if (is_standard_output(options.path) && ::isatty(STDOUT_FILENO) == 1) {
        throw Error(ErrorCode::usage,
                    "-o -: standard output is a terminal; redirect it to a file or a program, or name a file");
    }
}

/// The error lists all output formats; that of the picture codec would list only its own.
void check_extension(const std::filesystem::path& path) {
    if (is_standard_output(path) || app::is_page(path) || image::is_animation(path)) return;
    std::vector<std::string> known = image::picture_file_extensions();
    const std::string ending = extension_of(path);
    if (std::ranges::find(known, ending) != known.end()) return;
    known.emplace_back(".html");
    std::ranges::copy(image::animation_extensions(), std::back_inserter(known));
    const std::string found = ending.empty()
                                  ? "it has no file extension"
                                  : fmt::format("'{}' is not an output format{}", ending, did_you_mean(ending, known));
    throw Error(ErrorCode::output_format_unknown,
                fmt::format("cannot write '{}': {}; use one of {}", path.string(), found, fmt::join(known, " ")));
}

/// Checks the files written beside a picture, such as a page.
void check_companions(const app::OutputOptions& options) {
    if (!options.page.empty() && !app::is_page(options.page)) {
        throw Error(ErrorCode::output_format_unknown,
                    fmt::format("--page '{}': the extension of a page is .html", options.page.string()));
    }
    if (!options.page.empty() && app::is_page(options.path)) {
        throw Error(ErrorCode::options_conflict,
                    fmt::format("'{}' is already an HTML page; drop --page, or use an image extension in -o",
                                options.path.string()));
    }
    const std::pair<const char*, const std::filesystem::path&> companions[] = {{"--page", options.page},
                                                                               {"--still", options.still}};
    for (const auto& [option, path] : companions) {
        if (path.empty()) continue;
        if (options.path.empty() || app::pictures_of(options) > 1 || app::is_series(options)) {
            throw Error(options.path.empty() ? ErrorCode::option_needs_another : ErrorCode::options_conflict,
                        fmt::format("{} needs exactly one picture; {}", option,
                                    options.path.empty() ? "name it with -o FILE"
                                                         : "write a series or an animation in a separate run"));
        }
        check_file_path(path);
    }
    if (!options.still.empty()) image::check_picture_extension(options.still);
}

void check_golden(const app::GoldenOptions& options) {
    check(options.comparison);
    if (!options.path.empty()) {
        // A read-only folder will do for a comparison.
        return options.bless ? image::check_picture_path(options.path) : image::check_picture_extension(options.path);
    }
    if (options.bless)
        throw Error(ErrorCode::option_needs_another, "--bless needs --golden FILE, the picture to replace");
    if (!options.comparison.diff.empty()) {
        throw Error(ErrorCode::option_needs_another, "--diff needs --golden FILE, the picture to compare with");
    }
}

/// A mistake that options can have.
struct Rule {
    bool is_broken;
    ErrorCode code;
    std::string text;
};

/// \throws Error for the first broken rule
void check_rules(std::initializer_list<Rule> rules) {
    for (const Rule& rule : rules) {
        if (rule.is_broken) throw Error(rule.code, rule.text);
    }
}

}  // namespace

void add_comparison_options(CommandLine& line, app::ComparisonOptions& options) {
    const AddOptions add(line, Group::comparison);
    add(setting::tolerance, options.tolerance);
    add(rows::diff, options.diff, {.use = FileUse::written});
}

void add_event_options(CommandLine& line, Group group, tracking::EventChoice& choice) {
    const AddOptions add(line, group);
    add(setting::events, choice);
}

void add_events_to_option(CommandLine& line, Group group, std::filesystem::path& file) {
    const AddOptions add(line, group);
    add(rows::events_to, file, {.standard_output = true, .use = FileUse::written});
}

void check_events_to(const std::filesystem::path& file, const app::RenderJob& job) {
    const fields::FilterRow& filter = *job.fields.filter;
    if (file.empty() || filter.traits.shows_object) return;
    throw Error(ErrorCode::options_conflict,
                fmt::format("--events-to needs a filter that marks objects, and --filter {} does not; drop one of them",
                            filter.name));
}

void add_output_options(CommandLine& line, app::OutputOptions& options) {
    const AddOptions add(line, Group::output);
    add(rows::output, options.path,
        {.letter = 'o',
         .help = fmt::format(
             ": {}; a page to watch the clip from: .html; or animated: {}; - = a PNG file to "
             "standard output; a series, one picture per brick, has a field in its name: {{brick:4}}, #### or %04d",
             fmt::join(image::picture_file_extensions(), " "), fmt::join(image::animation_extensions(), " ")),
         .standard_output = true,
         .use = FileUse::written});
    add(setting::animate, options.animate,
        {.help = fmt::format("; FILE is animated ({} if not given) or has a field: {{frame:4}}, #### or %04d",
                             app::default_animation)});
    add(setting::slide, options.slide,
        {.help = fmt::format("; FILE is animated: {}", fmt::join(image::animation_extensions(), " "))});
    add(rows::page, options.page, {.use = FileUse::written});
    add(rows::flat_page, options.flat_page);
    add(rows::still, options.still, {.use = FileUse::written});
    add(rows::report, options.report, {.standard_output = true, .use = FileUse::written});
    add(rows::events_csv, options.events_csv, {.use = FileUse::written});
    add(rows::tracks, options.tracks, {.use = FileUse::written});
    add_event_options(line, Group::output, options.events);
    const AddOptions add_comparison(line, Group::comparison);
    add_comparison(rows::golden, options.golden.path, {.use = FileUse::compared});
    add_comparison(setting::bless, options.golden.bless);
    add_comparison_options(line, options.golden.comparison);
    const AddOptions plan(line, Group::plan);
    plan({"plain-name", "", ""}, options.plain_name);
    plan({"page-camera", "", ""}, options.page_camera);
    plan({"page-heading", "", ""}, options.page_heading);
    plan({"page-index", "", ""}, options.page_index);
    plan({"page-place", "", ""}, options.page_place);
    plan({"pieces", "", ""}, options.pieces.folder);
    plan({"pieces-margin", "TIME", "", {0, 3600}}, options.pieces.margin);
    plan({"pieces-place", "", ""}, options.pieces.place);
    plan({"stills", "", ""}, options.stills);
    plan({"thumbnail", "", ""}, options.thumbnail);
}

void check(const app::ComparisonOptions& options) {
    if (!options.diff.empty()) image::check_picture_path(options.diff);
}

void check(const app::OutputOptions& options) {
    check_golden(options.golden);
    check_standard_output(options);
    if (!options.report.empty() && !is_standard_output(options.report)) check_file_path(options.report);
    for (const std::filesystem::path* const table : {&options.events_csv, &options.tracks}) {
        if (!table->empty()) check_file_path(*table);
    }
    check_companions(options);
    const std::string text = options.path.string();
    const bool compared = !options.golden.path.empty();
    const std::string animations = fmt::format("{}", fmt::join(image::animation_extensions(), " "));
    check_rules(
        {{text.empty() && !compared && !options.lists_events(), ErrorCode::output_missing,
          "no output given; name the file for the picture with -o FILE"},
         {options.slide && options.animate, ErrorCode::options_conflict,
          "--slide moves the window, --animate only the stripes of one picture; drop --animate: with --slide, stripes "
          "move too"},
         {options.slide && !image::is_animation(options.path), ErrorCode::options_conflict,
          fmt::format("--slide makes a video, but '{}' has the extension of a picture; use one of {}", text,
                      animations)},
         {compared && options.slide, ErrorCode::options_conflict,
          "--golden compares one picture, but --slide makes a video; drop one of them"},
         {text.empty() && options.animate, ErrorCode::output_missing, "--animate: name the pictures with -o FILE"},
         {compared && app::pictures_of(options) > 1, ErrorCode::options_conflict,
          "--golden compares one picture, but --animate makes many; drop one of them"}});
    if (text.empty()) return;
    check_extension(options.path);
    const image::NamePattern name = app::name_of(options);
    const bool page = app::is_page(options.path);
    const bool animation = image::is_animation(options.path);
    check_rules(
        {{page && name.has_field(), ErrorCode::name_pattern_invalid,
          fmt::format("'{}': a page has one picture; use a name without a field", text)},
         {page && options.animate, ErrorCode::options_conflict,
          fmt::format("'{}': a page has one picture; drop --animate", text)},
         {animation && name.has_field(), ErrorCode::name_pattern_invalid,
          fmt::format("'{}': an animated file has all pictures; use a name without a field", text)},
         {name.counts() == "brick" && options.animate, ErrorCode::options_conflict,
          fmt::format("'{}' names a series, one picture per brick, which can't be animated; use {{frame}} with "
                      "--animate",
                      text)},
         {name.counts() == "frame" && !options.animate, ErrorCode::option_needs_another,
          fmt::format("'{}' has a field for the pictures of an animation; give their number with --animate, or use "
                      "{{brick}} for a series",
                      text)},
         {options.animate && !animation && !name.has_field(), ErrorCode::options_conflict,
          fmt::format("--animate makes {} pictures, but '{}' names only one; use a name like out.{{frame:4}}.png, or "
                      "an animated file: {}",
                      options.animate.value_or(0), text, animations)}});
}

void check_outputs(const app::RenderJob& job) {
    const app::OutputOptions& output = job.output;
    if (app::pictures_of(output) > 1 && !app::is_series(output) && !job.look.show.has(app::Part::tracelines)) {
        throw Error(ErrorCode::option_needs_another,
                    "an animation moves the stripes of tracelines, but the picture shows none; add them with "
                    "--show volume,tracelines,outline,frames");
    }
}

}  // namespace vvr::options
