#include "cli/write/golden.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <sstream>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/image/picture_file.h"

namespace vvr::app {

void show_difference(const image::Comparison& comparison, const image::Tolerance& tolerance, std::string_view a,
                     std::string_view b, Observer& observer) {
    for (const image::PixelPair& pixel : comparison.worst) {
        observer.info(fmt::format("at {},{}: {} {:.4f} and {} {:.4f} differ by {:.4f}", pixel.column, pixel.row, a,
                                  fmt::join(pixel.a, " "), b, fmt::join(pixel.b, " "), pixel.difference));
    }
    if (!comparison.has_numbers()) return;
    std::istringstream letters(image::difference_letters(comparison.pixels, tolerance.level));
    for (std::string line; std::getline(letters, line);) observer.info(line);
}

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::byte>;

void remove_candidate(const fs::path& golden) {
    std::error_code none;
    fs::remove(candidate_of(golden), none);
}

/// Writes the candidate and throws. If the candidate can't be written, the error still says that the pictures differ.
/// \throws Error with `code`; the text has the candidate's path or why it could not be written
[[noreturn]] void fail(ErrorCode code, const std::string& what, const fs::path& golden, const Bytes& bytes) {
    const fs::path candidate = candidate_of(golden);
    try {
        replace_link(candidate, bytes);  // nobody has named this file, and a link may lead anywhere
    } catch (const Error& error) {
        throw Error(code, fmt::format("{}; the new picture could not be saved beside it: {}", what, error.what()));
    }
    throw Error(
        code,
        fmt::format("{}; look at '{}', and if it is correct, make it the golden picture", what, candidate.string()),
        {"bless"});
}

/// Logs other possible causes of a difference: the renderer, the font, and settings that both pictures record.
void show_other_differences(const fs::path& golden, const image::Metadata& before, const image::Metadata& now,
                            Observer& observer) {
    constexpr std::size_t most = 5;
    std::vector<std::string> differ;
    for (const auto& [name, value] : now) {
        const std::string was = image::value_of(before, name);
        if (!was.empty() && was != value) differ.push_back(fmt::format("{} was {}, now {}", name, was, value));
    }
    if (differ.empty()) return;
    const std::size_t shown = std::min(most, differ.size());
    observer.info(fmt::format("'{}' was drawn with other settings: {}{}", golden.string(),
                              fmt::join(std::span(differ).first(shown), "; "),
                              differ.size() > shown ? fmt::format("; and {} more", differ.size() - shown) : ""));
}

}  // namespace

fs::path candidate_of(const fs::path& golden) {
    return fs::path(golden).replace_extension(".candidate" + golden.extension().string());
}

void check_golden_picture(const GoldenOptions& options) {
    std::error_code none;
    if (options.path.empty() || options.bless || !fs::exists(options.path, none)) return;
    static_cast<void>(image::read_samples(options.path));
}

void compare_with_golden(const GoldenOptions& options, const image::Picture& picture, const image::Metadata& metadata,
                         Observer& observer) {
    const fs::path& golden = options.path;
    const ComparisonOptions& how = options.comparison;
    const Bytes bytes = image::encode_picture(golden, picture, metadata);
    const auto held = observer.guard();
    if (options.bless) {
        replace_file(golden, bytes);
        remove_candidate(golden);
        observer.info(fmt::format("'{}': replaced by the new picture", golden.string()));
        return;
    }
    if (!fs::exists(golden)) {
        fail(ErrorCode::reference_missing, fmt::format("golden picture '{}' does not exist", golden.string()), golden,
             bytes);
    }
    const image::Samples expected = image::without_pixel_data(image::read_samples(golden));
    const image::Comparison comparison = image::compare(expected, image::decode_samples(golden, bytes), how.tolerance);
    if (options.compared) options.compared(comparison);
    if (comparison.has_numbers() && !how.diff.empty())
        image::write_picture(how.diff, image::difference_picture(expected, comparison));
    show_other_differences(golden, image::settings_of(expected), metadata, observer);
    if (comparison.verdict == image::Verdict::same) {
        remove_candidate(golden);
        observer.info(fmt::format("'{}': matches; {:.4f} % of the pixels differ, the worst patch by {:.4f}",
                                  golden.string(), comparison.percent, comparison.patch));
        return;
    }
    show_difference(comparison, how.tolerance, "golden", "now", observer);
    fail(ErrorCode::picture_differs,
         fmt::format("the picture differs from '{}': {}", golden.string(), comparison.reason), golden, bytes);
}

}  // namespace vvr::app
