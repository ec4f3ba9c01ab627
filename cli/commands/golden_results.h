#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace vvr::commands {

/// What came of a golden picture.
enum class GoldenVerdict { same, blessed, differs, missing, failed };

/// The name in reports.
std::string_view name_of(GoldenVerdict verdict);

/// The numbers of a comparison.
struct GoldenNumbers {
    double percent = 0;  ///< of the pixels that differ
    double patch = 0;    ///< largest mean difference of a patch
    double max = 0;
};

struct GoldenResult {
    std::string name;
    GoldenVerdict verdict = GoldenVerdict::same;
    std::optional<ErrorCode> code{};  ///< if it is not well
    std::string reason{};
    std::optional<GoldenNumbers> numbers{};  ///< none if nothing was compared
    double seconds = 0;

    bool is_well() const { return verdict == GoldenVerdict::same || verdict == GoldenVerdict::blessed; }
};

/// The results as JUnit XML, as CI systems read it: a picture that differs or is missing is a failure, one that can't
/// be drawn is an error.
std::string junit_of(const std::string& folder, std::span<const GoldenResult> results);

/// The same as JSON.
std::string json_of(const std::string& folder, std::span<const GoldenResult> results);

}  // namespace vvr::commands
