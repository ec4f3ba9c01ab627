#include "cli/options_output.h"

#include <fmt/format.h>

#include "cli/option.h"
#include "core/image/picture_file.h"

namespace vvr {

void add_options(CLI::App& app, OutputOptions& options) {
    add_option(app, group::output, options.path,
               {"-o,--output", "FILE", "", fmt::format("the picture: {}", fmt::join(picture_endings(), " "))},
               [](const std::string& given) { return std::filesystem::path(given); });
}

void check(const OutputOptions& options) {
    if (options.path.empty()) throw Error(ErrorKind::usage, "no output: say where the picture goes with -o FILE");
}

}  // namespace vvr
