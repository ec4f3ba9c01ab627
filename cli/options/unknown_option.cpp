#include "cli/options/unknown_option.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/base/setting.h"

namespace vvr::options {

namespace {

/// Options of other programs that people try here, and the equivalent.
constexpr std::pair<std::string_view, std::string_view> options_elsewhere[] = {
    {"-i", "give an input without an option: vvr COMMAND FILE"},
    {"-ss", "use --start TIME"},
    {"-st", "use --start TIME"},
    {"-to", "use --end TIME"},
    {"-et", "use --end TIME"},
    {"-t", "use --start TIME and --end TIME"},
    {"-r", "use --rate FPS, for input without times"},
    {"-framerate", "use --rate FPS, for input without times"},
    {"-y", "vvr replaces outputs without asking"},
    {"-threads", "use --threads COUNT"},
    {"--frame-rate", "use --rate FPS, for input without times"},
    {"--resolution", "use --size WxH"},
    {"--colormap", "use --transfer NAME"},
    {"--background-color", "use --background COLOR"},
    {"-R", "use --roi FILE"},
    {"--add-region", "use --roi AREA"},
    {"--load-region", "use --roi FILE"},
    {"--min-event-length", "use --events TIME"},
    {"--frame-skip", "use --step FRAMES; vvr skips none, frames share a layer"},
};

}  // namespace

Error unknown_option(const std::string& name, std::span<const std::string> known, const std::string& command) {
    const auto row = std::ranges::find(options_elsewhere, name, [](const auto& r) { return r.first; });
    const std::string instead =
        row == std::end(options_elsewhere) ? did_you_mean(name, known) : fmt::format(": {}", row->second);
    return {ErrorCode::option_unknown,
            fmt::format("there is no option '{}'{}; `{} --help` lists them", name, instead, command)};
}

}  // namespace vvr::options
