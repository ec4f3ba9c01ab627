#include "cli/commands/golden_results.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/page/html.h"

namespace vvr::commands {

namespace {

constexpr std::array<std::string_view, 5> verdict_names{"same", "blessed", "differs", "missing", "error"};

std::size_t count(std::span<const GoldenResult> results, bool failed) {
    return static_cast<std::size_t>(std::ranges::count_if(results, [&](const GoldenResult& result) {
        return !result.is_well() && (result.verdict == GoldenVerdict::failed) == failed;
    }));
}

double seconds_of(std::span<const GoldenResult> results) {
    double seconds = 0;
    for (const GoldenResult& result : results) seconds += result.seconds;
    return seconds;
}

/// Text of XML. Control characters and bytes that are not UTF-8 have no place in it, even escaped.
std::string xml(std::string_view text) {
    return page::html_text(shown_text(text));
}

Json rounded(double value) {
    return std::round(value * 1e6) / 1e6;
}

}  // namespace

std::string_view name_of(GoldenVerdict verdict) {
    return verdict_names.at(static_cast<std::size_t>(verdict));
}

std::string junit_of(const std::string& folder, std::span<const GoldenResult> results) {
    const std::string counts = fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\"", results.size(),
                                           count(results, false), count(results, true), seconds_of(results));
    std::string text = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"vvr golden\" {0}>\n"
        "  <testsuite name=\"{1}\" {0} skipped=\"0\">\n",
        counts, xml(folder));
    for (const GoldenResult& result : results) {
        text += fmt::format("    <testcase name=\"{}\" classname=\"{}\" time=\"{:.3f}\"", xml(result.name), xml(folder),
                            result.seconds);
        if (result.is_well()) {
            text += "/>\n";
            continue;
        }
        const std::string_view element = result.verdict == GoldenVerdict::failed ? "error" : "failure";
        text += fmt::format(">\n      <{0} type=\"{1}\" message=\"{2}\">{2}</{0}>\n    </testcase>\n", element,
                            row_of(result.code.value_or(ErrorCode::bug)).name, xml(result.reason));
    }
    return text + "  </testsuite>\n</testsuites>\n";
}

std::string json_of(const std::string& folder, std::span<const GoldenResult> results) {
    Json json{{"golden", 1},
              {"vvr", version()},
              {"folder", folder},
              {"differ", count(results, false)},
              {"failed", count(results, true)},
              {"pictures", Json::array()}};
    for (const GoldenResult& result : results) {
        const auto number = [&](double GoldenNumbers::*member) {
            return result.numbers ? rounded((*result.numbers).*member) : Json();
        };
        json["pictures"].push_back({{"name", result.name},
                                    {"verdict", name_of(result.verdict)},
                                    {"code", result.code ? Json(row_of(*result.code).name) : Json()},
                                    {"reason", result.is_well() ? Json() : Json(result.reason)},
                                    {"percent_off", number(&GoldenNumbers::percent)},
                                    {"patch", number(&GoldenNumbers::patch)},
                                    {"max", number(&GoldenNumbers::max)},
                                    {"seconds", rounded(result.seconds)}});
    }
    return json_text(json, 2) + "\n";
}

}  // namespace vvr::commands
