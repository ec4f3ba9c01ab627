#include "cli/options/output.h"

#include <algorithm>
#include <cctype>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "cli/options/option.h"
#include "core/image/animation_file.h"
#include "core/image/atomic_file.h"
#include "core/image/picture_file.h"

namespace vvr {

namespace {

constexpr int standard_animation = 24;

constexpr std::string_view page_ending = ".html";

/// Whether both name one file, be it there or not.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code none;
    const auto whole = [&](const auto& path) {
        return std::filesystem::weakly_canonical(std::filesystem::absolute(path), none);
    };
    return !a.empty() && !b.empty() && whole(a) == whole(b);
}

bool ends_as_page(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == page_ending || ending == ".htm";
}

/// The outputs that an option of their own names.
struct Named {
    const char* option;
    const std::filesystem::path& path;
    const char* better;  ///< a name to take instead
};

void check_names(const OutputOptions& options) {
    const Named outputs[] = {
        {"--report", options.report, "report.json"},     {"--page", options.page, "page.html"},
        {"--thumbnail", options.thumbnail, "small.jpg"}, {"-o", options.path, "picture.png"},
        {"--golden", options.golden.path, "golden.png"}, {"--diff", options.golden.comparison.diff, "diff.png"}};
    for (const Named& a : outputs) {
        for (const Named& b : std::span(outputs).subspan(static_cast<std::size_t>(&a - outputs) + 1)) {
            // What a golden picture is compared with, and where the difference goes, is for that group to check.
            if (&a - outputs > 2 || !same_file(a.path, b.path)) continue;
            throw Error(ErrorKind::usage,
                        fmt::format("{} and {} both name '{}'; give the {} a name of its own, such as {}", a.option,
                                    b.option, b.path.string(), a.option + 2, a.better));
        }
    }
}

/// The page and the thumbnail that come beside a picture.
void check_companions(const OutputOptions& options) {
    if (!options.page.empty() && !ends_as_page(options.page)) {
        throw Error(ErrorKind::usage,
                    fmt::format("--page '{}': a page's name ends in {}", options.page.string(), page_ending));
    }
    if (!options.page.empty() && is_page(options)) {
        throw Error(ErrorKind::usage,
                    fmt::format("'{}' is a page already; leave out --page, or give -o the name of a picture",
                                options.path.string()));
    }
    const std::pair<const char*, const std::filesystem::path&> companions[] = {{"--page", options.page},
                                                                               {"--thumbnail", options.thumbnail}};
    for (const auto& [option, path] : companions) {
        if (path.empty()) continue;
        if (options.path.empty() || pictures_of(options) > 1 || is_series(options)) {
            throw Error(ErrorKind::usage,
                        fmt::format("{} goes with one picture; {}", option,
                                    options.path.empty() ? "say where that goes with -o FILE" : "make those apart"));
        }
        check_file_path(path);
    }
    if (!options.thumbnail.empty()) check_picture_ending(options.thumbnail);
}

}  // namespace

void add_options(CLI::App& app, OutputOptions& options) {
    add_option(app, group::output, options.path,
               {"-o,--output", "FILE", "",
                fmt::format("the picture: {}; a page to watch the clip from it: {}; or animated: {}; a series, one "
                            "picture for each brick, has a field in its "
                            "name: {{brick:4}}, #### or %04d",
                            fmt::join(picture_endings(), " "), page_ending, fmt::join(animation_endings(), " "))},
               [](const std::string& given) { return std::filesystem::path(given); });
    app.add_flag("--plain-name", options.plain_name, "FILE has no field, whatever stands in its name")
        ->group(group::output);
    add_option(
        app, group::output, options.animate,
        {"--animate", "COUNT", "",
         fmt::format("so many pictures in which stripes run along the tracelines, 2..10000; FILE is animated ({} "
                     "if not given) or has a field: {{frame:4}}, #### or %04d",
                     standard_animation)},
        [](const std::string& given) { return static_cast<int>(parse_integer(given, 2, 10'000)); });
    add_option(app, group::output, options.page,
               {"--page", "FILE", "", "a page to watch the clip from it, beside the picture: .html"},
               [](const std::string& given) { return std::filesystem::path(given); });
    add_option(app, group::output, options.thumbnail,
               {"--thumbnail", "FILE", "", "the picture once more, small: .jpg .png"},
               [](const std::string& given) { return std::filesystem::path(given); });
    add_option(app, group::output, options.report,
               {"--report", "FILE", "", "a JSON file of the input, the settings, the events and the run; needs no -o"},
               [](const std::string& given) { return std::filesystem::path(given); });
    add_options(app, options.events);
    add_options(app, options.golden);
}

void check(const OutputOptions& options) {
    check(options.golden);
    if (!options.report.empty()) check_file_path(options.report);
    check_names(options);
    check_companions(options);
    if (options.path.empty() && options.golden.path.empty() && options.report.empty()) {
        throw Error(ErrorKind::usage, "no output: say where the picture goes with -o FILE");
    }
    if (options.path.empty() && options.animate) {
        throw Error(ErrorKind::usage, "--animate: say where the pictures go with -o FILE");
    }
    if (!options.golden.path.empty() && pictures_of(options) > 1) {
        throw Error(ErrorKind::usage, "--golden compares one picture, and --animate makes many; leave one of them out");
    }
    if (options.path.empty()) return;
    const NamePattern name = name_of(options);
    const std::string text = options.path.string();
    if (is_page(options)) {
        if (!name.has_field() && !options.animate) return;
        throw Error(ErrorKind::usage,
                    fmt::format("'{}': a page holds one picture; {}", text,
                                name.has_field() ? "its name takes no field" : "leave out --animate"));
    }
    if (is_animation(options.path)) {
        if (!name.has_field()) return;
        throw Error(ErrorKind::usage,
                    fmt::format("'{}': an animated file holds all pictures; its name takes no field", text));
    }
    if (name.counts() == "brick" && options.animate) {
        throw Error(ErrorKind::usage, fmt::format("'{}' is the name of a series, a picture for each brick, and none of "
                                                  "them is animated; --animate takes {{frame}}",
                                                  text));
    }
    if (name.counts() == "frame" && !options.animate) {
        throw Error(ErrorKind::usage,
                    fmt::format("'{}' has a field for the pictures of an animation; say how many with "
                                "--animate, or take {{brick}} for a series",
                                text));
    }
    if (options.animate && !name.has_field()) {
        throw Error(
            ErrorKind::usage,
            fmt::format("--animate makes {} pictures, but '{}' is the name of one; take one like out.{{frame:4}}.png, "
                        "or an animated file: {}",
                        *options.animate, text, fmt::join(animation_endings(), " ")));
    }
}

void check_report(const OutputOptions& options, const std::vector<std::string>& inputs) {
    for (const std::string& input : inputs) {
        if (!same_file(options.report, input)) continue;
        throw Error(ErrorKind::usage, fmt::format("--report '{}' would replace the input; give the report a name of "
                                                  "its own, such as report.json",
                                                  options.report.string()));
    }
}

NamePattern name_of(const OutputOptions& options) {
    return options.plain_name ? NamePattern::literal(options.path) : NamePattern(options.path);
}

bool is_series(const OutputOptions& options) {
    return !options.animate && name_of(options).has_field();
}

bool is_page(const OutputOptions& options) {
    return ends_as_page(options.path);
}

const std::filesystem::path& page_of(const OutputOptions& options) {
    return is_page(options) ? options.path : options.page;
}

int pictures_of(const OutputOptions& options) {
    if (options.path.empty() && options.golden.path.empty()) return 0;
    return options.animate.value_or(is_animation(options.path) ? standard_animation : 1);
}

}  // namespace vvr
