#include "cli/options/output.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/app/golden.h"
#include "cli/app/settings.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/setting.h"
#include "core/image/atomic_file.h"
#include "core/image/name_pattern.h"
#include "core/image/picture_file.h"
#include "core/image/video_encoder.h"
#include "core/video/frame_source.h"
#include "core/video/input_files.h"

namespace vvr::options {

namespace {

namespace text {
constexpr Setting output{"output", "FILE", "the picture"};
constexpr Setting plain_name{"plain-name", "", "take FILE literally: its name has no field"};
constexpr Setting page{"page", "FILE", "a page to watch the clip from, beside the picture: .html"};
constexpr Setting page_camera{"page-camera", "TEXT", "the camera that the page names in its heading"};
constexpr Setting page_index{"page-index", "FILE", "the index of an archive, to which the page links"};
constexpr Setting page_place{"page-place", "FILE",
                             "file to which the page will be moved; its links are relative to that place"};
constexpr Setting thumbnail{"thumbnail", "FILE", "the picture again, small: .jpg .png"};
constexpr Setting still{"still", "FILE",
                        "the frame of the clip that shows most, with a box around what it shows: .jpg .png"};
constexpr Setting report{
    "report", "FILE",
    "a JSON file of the input, the settings, the events and the run; needs no -o; - = standard output"};
constexpr Setting events{"events", "LIST", "kinds of events that the report and the page list"};
constexpr Setting event_min_seconds{"event-min-seconds", "TIME", "leave out shorter events", {0, 86'400}};
constexpr Setting golden{"golden", "FILE",
                         "compare with this picture; if they differ, exit with 7 and keep the candidate beside it"};
constexpr Setting bless{"bless", "", "replace the golden picture instead of comparing; writes no --diff"};
constexpr Setting diff{"diff", "FILE",
                       "picture of the differences: yellow = small, red = larger, black = the full range"};
}  // namespace text

std::set<events::EventKind> parse_kinds(const std::string& list) {
    std::set<events::EventKind> kinds;
    std::istringstream words(list);
    for (std::string word; std::getline(words, word, ',');) {
        kinds.insert(choose(text::events.name, word, events::event_kinds).kind);
    }
    return kinds;
}

/// Whether both paths name the same file. It need not exist.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code none;
    if (std::filesystem::equivalent(a, b, none)) return true;
    const auto whole = [&](const auto& path) {
        return std::filesystem::weakly_canonical(std::filesystem::absolute(path), none);
    };
    return !a.empty() && !b.empty() && whole(a) == whole(b);
}

/// An output and the option that names it.
struct Named {
    const char* option;
    const std::filesystem::path& path;
    const char* better;  ///< a name to suggest instead
};

void check_names(const app::OutputOptions& options) {
    const Named outputs[] = {{"--report", options.report, "report.json"},
                             {"--page", options.page, "page.html"},
                             {"--thumbnail", options.thumbnail, "small.jpg"},
                             {"--still", options.still, "still.jpg"},
                             {"-o", options.path, "picture.png"},
                             {"--golden", options.golden.path, "golden.png"},
                             {"--diff", options.golden.comparison.diff, "diff.png"}};
    for (const Named& a : outputs) {
        for (const Named& b : std::span(outputs).subspan(static_cast<std::size_t>(&a - outputs) + 1)) {
            // check_golden checks these pairs.
            if (&a - outputs > 3 || !same_file(a.path, b.path)) continue;
            throw Error(ErrorCode::options_conflict,
                        fmt::format("{} and {} both name '{}'; give the {} a name of its own, such as {}", a.option,
                                    b.option, b.path.string(), a.option + 2, a.better));
        }
    }
}

/// Standard output can hold one picture or the report, not both.
void check_standard_output(const app::OutputOptions& options) {
    if (!is_standard_output(options.path)) return;
    if (is_standard_output(options.report)) {
        throw Error(ErrorCode::options_conflict,
                    "-o and --report both go to standard output; name a file for one of them");
    }
    if (::isatty(STDOUT_FILENO) == 1) {
        throw Error(ErrorCode::usage,
                    "-o -: standard output is a terminal, and would show a PNG file as letters; send it to a program, "
                    "or name a file");
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
    throw Error(ErrorCode::output_format_unknown,
                fmt::format("cannot write '{}': {} is not an output format{}; there are {}", path.string(),
                            ending.empty() ? "a name without an ending" : "'" + ending + "'",
                            did_you_mean(ending, known), fmt::join(known, " ")));
}

/// Checks the files written beside a picture, such as page and thumbnail.
void check_companions(const app::OutputOptions& options) {
    if (!options.page.empty() && !app::is_page(options.page)) {
        throw Error(ErrorCode::output_format_unknown,
                    fmt::format("--page '{}': a page's name ends in .html", options.page.string()));
    }
    if (!options.page.empty() && app::is_page(options.path)) {
        throw Error(ErrorCode::options_conflict,
                    fmt::format("'{}' is a page already; leave out --page, or give -o the name of a picture",
                                options.path.string()));
    }
    const std::pair<const char*, const std::filesystem::path&> companions[] = {
        {"--page", options.page}, {"--thumbnail", options.thumbnail}, {"--still", options.still}};
    for (const auto& [option, path] : companions) {
        if (path.empty()) continue;
        if (options.path.empty() || app::pictures_of(options) > 1 || app::is_series(options)) {
            throw Error(
                options.path.empty() ? ErrorCode::option_needs_another : ErrorCode::options_conflict,
                fmt::format("{} goes with one picture; {}", option,
                            options.path.empty() ? "say where that goes with -o FILE" : "make those separately"));
        }
        image::check_file_path(path);
    }
    if (!options.thumbnail.empty()) image::check_picture_extension(options.thumbnail);
    if (!options.still.empty()) image::check_picture_extension(options.still);
    if (!app::page_of(options).empty()) return;
    const std::pair<const Setting&, bool> of_page[] = {{text::page_camera, !options.page_camera.empty()},
                                                       {text::page_index, !options.page_index.empty()},
                                                       {text::page_place, !options.page_place.empty()}};
    for (const auto& [setting, given] : of_page) {
        if (!given) continue;
        throw Error(ErrorCode::option_needs_another,
                    fmt::format("--{} is for a page; name one with --page FILE, or as -o FILE.html", setting.name));
    }
}

void check_golden(const app::GoldenOptions& options) {
    check(options.comparison);
    if (!options.path.empty()) {
        // A read-only folder will do for a comparison.
        return options.bless ? image::check_picture_path(options.path) : image::check_picture_extension(options.path);
    }
    if (options.bless)
        throw Error(ErrorCode::option_needs_another, "--bless: add --golden FILE to say which picture is blessed");
    if (!options.comparison.diff.empty()) {
        throw Error(ErrorCode::option_needs_another,
                    "--diff: add --golden FILE to say what the picture is compared with");
    }
}

}  // namespace

void add_comparison_options(CommandLine& line, app::ComparisonOptions& options) {
    line.number(Group::comparison, options.tolerance.level, setting::tolerance);
    line.number(Group::comparison, options.tolerance.percent, setting::tolerance_percent);
    line.number(Group::comparison, options.tolerance.patch, setting::tolerance_patch);
    line.path(Group::comparison, options.diff, text::diff, {.use = FileUse::written});
}

void add_event_options(CommandLine& line, Group group, events::EventChoice& choice) {
    line.value(group, text::events, fmt::format("{}", fmt::join(names_of(events::event_kinds), ",")),
               [&choice](const std::string& given) { choice.kinds = parse_kinds(given); },
               {.values = values_of(events::event_kinds)});
    line.duration(group, choice.least, text::event_min_seconds);
}

void add_output_options(CommandLine& line, app::OutputOptions& options) {
    constexpr Group output = Group::output;
    line.path(
        output, options.path, text::output,
        {.letter = 'o',
         .help = fmt::format(
             ": {}; a page to watch the clip from: .html; or animated: {}; - = a PNG file to "
             "standard output; a series, one picture per brick, has a field in its name: {{brick:4}}, #### or %04d",
             fmt::join(image::picture_file_extensions(), " "), fmt::join(image::animation_extensions(), " ")),
         .standard_output = true,
         .use = FileUse::written});
    line.flag(output, options.plain_name, text::plain_name);
    line.number(output, options.animate, setting::animate,
                {.help = fmt::format("; FILE is animated ({} if not given) or has a field: {{frame:4}}, #### or %04d",
                                     app::default_animation)});
    line.number(output, options.slide, setting::slide,
                {.help = fmt::format("; FILE is animated: {}", fmt::join(image::animation_extensions(), " "))});
    line.path(output, options.page, text::page, {.use = FileUse::written});
    line.text(output, options.page_camera, text::page_camera);
    line.path(output, options.page_index, text::page_index);
    line.path(output, options.page_place, text::page_place);
    line.path(output, options.thumbnail, text::thumbnail, {.use = FileUse::written});
    line.path(output, options.still, text::still, {.use = FileUse::written});
    line.path(output, options.report, text::report, {.standard_output = true, .use = FileUse::written});
    add_event_options(line, output, options.events);
    line.path(Group::comparison, options.golden.path, text::golden, {.use = FileUse::compared});
    line.flag(Group::comparison, options.golden.bless, text::bless);
    add_comparison_options(line, options.golden.comparison);
}

void check(const app::ComparisonOptions& options) {
    if (!options.diff.empty()) image::check_picture_path(options.diff);
}

void check(const app::OutputOptions& options) {
    check_golden(options.golden);
    check_standard_output(options);
    if (!options.report.empty() && !is_standard_output(options.report)) image::check_file_path(options.report);
    check_names(options);
    check_companions(options);
    if (options.path.empty() && options.golden.path.empty() && options.report.empty()) {
        throw Error(ErrorCode::output_missing, "no output: say where the picture goes with -o FILE");
    }
    if (options.slide && options.animate) {
        throw Error(ErrorCode::options_conflict,
                    "--slide moves the window and --animate the stripes of one picture; leave one of them out: with "
                    "--slide stripes run too");
    }
    if (options.slide && !image::is_animation(options.path)) {
        throw Error(ErrorCode::options_conflict,
                    fmt::format("--slide makes a film, but '{}' is none; name one: {}", options.path.string(),
                                fmt::join(image::animation_extensions(), " ")));
    }
    if (!options.golden.path.empty() && options.slide) {
        throw Error(ErrorCode::options_conflict,
                    "--golden compares one picture, and --slide makes a film; leave one of them out");
    }
    if (options.path.empty() && options.animate) {
        throw Error(ErrorCode::output_missing, "--animate: say where the pictures go with -o FILE");
    }
    if (!options.golden.path.empty() && app::pictures_of(options) > 1) {
        throw Error(ErrorCode::options_conflict,
                    "--golden compares one picture, and --animate makes many; leave one of them out");
    }
    if (options.path.empty()) return;
    check_extension(options.path);
    const image::NamePattern name = app::name_of(options);
    const std::string text = options.path.string();
    if (app::is_page(options.path)) {
        if (!name.has_field() && !options.animate) return;
        throw Error(name.has_field() ? ErrorCode::name_pattern_invalid : ErrorCode::options_conflict,
                    fmt::format("'{}': a page holds one picture; {}", text,
                                name.has_field() ? "its name takes no field" : "leave out --animate"));
    }
    if (image::is_animation(options.path)) {
        if (!name.has_field()) return;
        throw Error(ErrorCode::name_pattern_invalid,
                    fmt::format("'{}': an animated file holds all pictures; its name takes no field", text));
    }
    if (name.counts() == "brick" && options.animate) {
        throw Error(ErrorCode::options_conflict,
                    fmt::format("'{}' is the name of a series, a picture for each brick, and none of "
                                "them is animated; --animate takes {{frame}}",
                                text));
    }
    if (name.counts() == "frame" && !options.animate) {
        throw Error(ErrorCode::option_needs_another,
                    fmt::format("'{}' has a field for the pictures of an animation; say how many with "
                                "--animate, or take {{brick}} for a series",
                                text));
    }
    if (options.animate && !name.has_field()) {
        throw Error(
            ErrorCode::options_conflict,
            fmt::format("--animate makes {} pictures, but '{}' is the name of one; take one like out.{{frame:4}}.png, "
                        "or an animated file: {}",
                        *options.animate, text, fmt::join(image::animation_extensions(), " ")));
    }
}

void check_outputs(const app::RenderJob& job) {
    const app::OutputOptions& output = job.output;
    if (app::pictures_of(output) > 1 && !app::is_series(output) && !job.look.show.has(app::Part::tracelines)) {
        throw Error(ErrorCode::option_needs_another,
                    "an animation moves the stripes of tracelines, and none are shown: add them with "
                    "--show volume,tracelines,outline,frames");
    }
}

namespace {

namespace fs = std::filesystem;

/// Identifies a file whatever its names. Symbolic links are followed.
using FileId = std::pair<dev_t, ino_t>;

std::optional<FileId> id_of(const fs::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    return FileId{status.st_dev, status.st_ino};
}

/// The existing files that a run would overwrite, each with its option and the name given.
class Outputs {
  public:
    void add(const OptionValue& option, const fs::path& path) {
        std::error_code none;
        if (fs::is_directory(path, none)) {
            // An older extraction is replaced as a whole. Any other folder is refused elsewhere.
            if (!fs::exists(path / "manifest.json", none)) return;
            fs::recursive_directory_iterator entry(path, fs::directory_options::skip_permission_denied, none);
            for (; !none && entry != fs::recursive_directory_iterator(); entry.increment(none)) put(*entry, option);
            return;
        }
        put(path, option);
        for (const fs::path& file : files_of_pattern(path)) put(file, option);
    }

    bool empty() const { return files_.empty(); }

    /// \param given the user's name for the input
    void refuse(const fs::path& read, const std::string& given) const {
        const std::optional<FileId> id = id_of(read);
        if (!id) return;
        const auto found = files_.find(*id);
        if (found == files_.end()) return;
        throw Error(ErrorCode::output_replaces_input,
                    fmt::format("{} '{}' would replace what is read, '{}'; choose another name", found->second.first,
                                found->second.second, given));
    }

  private:
    void put(const fs::path& path, const OptionValue& option) {
        if (const std::optional<FileId> id = id_of(path)) {
            const std::string flag = option.name == "output" ? "-o" : "--" + option.name;
            files_.emplace(*id, std::pair(flag, option.value));
        }
    }

    /// The existing files of a series or an animation.
    static std::vector<fs::path> files_of_pattern(const fs::path& path) {
        std::vector<fs::path> files;
        try {
            const image::NamePattern pattern(path);
            const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
            std::error_code none;
            if (!pattern.has_field()) return {};
            for (fs::directory_iterator entry(folder, none); !none && entry != fs::directory_iterator();
                 entry.increment(none)) {
                if (pattern.may_be(entry->path().filename().string())) files.push_back(entry->path());
            }
        } catch (const Error&) {
            return {};  // a check of the name itself reports the error
        }
        return files;
    }

    std::map<FileId, std::pair<std::string, std::string>> files_;
};

}  // namespace

void check_no_input_overwritten(const CommandLine& line) {
    Outputs outputs;
    const std::vector<OptionValue> given = line.given(all_groups);
    const bool blessed = std::ranges::find(given, "bless", &OptionValue::name) != given.end();
    std::vector<std::string> inputs = line.arguments();
    if (!line.config().file.empty()) inputs.push_back(line.config().file.string());
    for (const OptionValue& option : line.values(all_groups)) {
        if (option.value.empty()) continue;
        const bool compared = option.use == FileUse::compared;
        if (option.use == FileUse::written || (compared && blessed)) outputs.add(option, option.value);
        if (option.use == FileUse::read || (compared && !blessed)) inputs.push_back(option.value);
        if (compared && !blessed) outputs.add(option, app::candidate_of(option.value));
    }
    if (outputs.empty()) return;
    for (const std::string& input : inputs) {
        for (const fs::path& file : video::files_of_input(input)) outputs.refuse(file, input);
    }
}

}  // namespace vvr::options
