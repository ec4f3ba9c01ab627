#include "cli/render/golden.h"

#include <algorithm>
#include <span>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "cli/render/show_comparison.h"
#include "core/error.h"
#include "core/image/atomic_file.h"
#include "core/image/difference_view.h"
#include "core/image/picture_file.h"

namespace vvr {

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::byte>;

void remove_candidate(const fs::path& golden) {
    std::error_code none;
    fs::remove(candidate_of(golden), none);
}

/// Leaves the candidate. \returns the sentence that says where it is and what to do, or why it could not be left: the
/// difference is the news, and a folder that can't be written must not hide it.
std::string leave_candidate(const fs::path& golden, const Bytes& bytes) {
    const fs::path candidate = candidate_of(golden);
    try {
        replace_file(candidate, bytes);
    } catch (const Error& error) {
        return fmt::format("the candidate could not be kept: {}", error.what());
    }
    return fmt::format("look at '{}', and if it is right, run the same with --bless", candidate.string());
}

std::string renderer_of(const Metadata& metadata) {
    const auto found = std::ranges::find(metadata, "renderer", &Metadata::value_type::first);
    return found == metadata.end() ? "" : found->second;
}

/// Another renderer is the first thing to suspect.
void log_renderers(const fs::path& golden, const Metadata& before_settings, const Metadata& metadata,
                   spdlog::logger& log) {
    const std::string before = renderer_of(before_settings);
    const std::string now = renderer_of(metadata);
    if (!before.empty() && before != now) log.info("'{}' was drawn by {}, this by {}", golden.string(), before, now);
}

}  // namespace

fs::path candidate_of(const fs::path& golden) {
    return fs::path(golden).replace_extension(".candidate" + golden.extension().string());
}

void meet_golden(const GoldenOptions& options, const Picture& picture, const Metadata& metadata,
                 const Environment& environment) {
    const fs::path& golden = options.path;
    const ComparisonOptions& how = options.comparison;
    const Bytes bytes = encode_picture(golden, picture, metadata);
    const auto held = environment.signals.hold();
    if (options.bless) {
        replace_file(golden, bytes);
        remove_candidate(golden);
        environment.log.info("'{}': blessed", golden.string());
        return;
    }
    if (!fs::exists(golden)) {
        throw Error(ErrorKind::differs, fmt::format("there is no golden picture '{}' to compare with; {}",
                                                    golden.string(), leave_candidate(golden, bytes)));
    }
    const Samples expected = without_pixel_data(read_samples(golden));
    const Comparison comparison = compare(expected, decode_samples(golden, bytes), how.tolerance);
    if (comparison.has_numbers() && !how.diff.empty())
        write_picture(how.diff, difference_picture(expected, comparison));
    if (comparison.verdict == Verdict::same) {
        remove_candidate(golden);
        environment.log.info("'{}': the same, {:.4f} % of the pixels off, the worst patch by {:.4f}", golden.string(),
                             comparison.percent, comparison.patch);
        return;
    }
    log_renderers(golden, settings_of(expected), metadata, environment.log);
    log_difference(comparison, how.tolerance, environment.log);
    throw Error(ErrorKind::differs, fmt::format("the picture differs from '{}': {}; {}", golden.string(),
                                                comparison.reason, leave_candidate(golden, bytes)));
}

}  // namespace vvr
