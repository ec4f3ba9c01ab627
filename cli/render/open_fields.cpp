#include "cli/render/open_fields.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "cli/options/option.h"
#include "core/error.h"
#include "core/fields/busy_fields.h"
#include "core/fields/listed_seeds.h"
#include "core/store/stored_fields.h"

namespace vvr {

namespace {

constexpr std::array<std::string_view, 5> options_with_files{"mask", "reference", "roi", "seeds", "transfer"};

OpenedFields open_extracted(const std::vector<std::string>& folders, const CommandLine& line) {
    auto source = std::make_unique<StoredFields>(folders);
    for (const std::string& option : line.names({group::input, group::fields})) {
        const std::optional<std::string> given = line.given(option);
        if (!given || option == "step" || option == "seeds") continue;
        const auto found = std::ranges::find(source->settings(), option, &Metadata::value_type::first);
        const std::string extracted = found == source->settings().end() ? "" : found->second;
        if (without_folder(option, *given) == extracted) continue;
        throw Error(ErrorKind::usage,
                    fmt::format("--{} {}: '{}' was extracted with {}; leave the option out, or run "
                                "`vvr extract` with it",
                                option, *given, folders.front(), extracted.empty() ? "none" : extracted));
    }
    Metadata settings = source->settings();
    return {std::move(source), std::move(settings)};
}

OpenedFields open_any(const RenderSettings& settings, const CommandLine& line) {
    const std::vector<std::string>& names = settings.input.names;
    if (std::ranges::all_of(names, is_data_folder)) return open_extracted(names, line);
    FieldOptions options = settings.fields;
    options.threads = settings.run.threads;
    options.span = span_of(settings.input);
    auto clip = open_clip(settings.input, wants_colour(settings), settings.run.threads);
    return {std::make_unique<ClipFields>(std::move(clip), options), {}};
}

}  // namespace

bool may_name_file(const std::string& option) {
    return std::ranges::find(options_with_files, option) != options_with_files.end();
}

std::string without_folder(const std::string& option, const std::string& value) {
    if (!may_name_file(option)) return value;
    const std::filesystem::path path(value);
    return (path.has_filename() ? path : path.parent_path()).filename().string();
}

OpenedFields open_fields(const RenderSettings& settings, const CommandLine& line) {
    OpenedFields opened = open_any(settings, line);
    if (!settings.seeds.empty())
        opened.source = std::make_unique<ListedSeeds>(std::move(opened.source), settings.seeds);
    if (settings.bricks.skip_idle > 0)
        opened.source = std::make_unique<BusyFields>(std::move(opened.source), settings.bricks.skip_idle);
    return opened;
}

}  // namespace vvr
