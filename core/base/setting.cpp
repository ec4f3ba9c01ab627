#include "core/base/setting.h"

#include <numeric>

#include <fmt/ranges.h>

namespace vvr {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    // Three rows of the dynamic programming table; swapped neighbours need the one before last.
    std::vector<std::size_t> before(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
        before.swap(last);
        last.swap(row);
    }
    return last[b.size()];
}

std::string nearest_name(std::string_view word, std::span<const std::string> names) {
    std::string nearest;
    std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string& name : names) {
        // A prefix of a name is close, however short.
        const bool beginning = word.size() >= 3 && name.starts_with(word);
        const std::size_t distance = beginning ? 1 : edit_distance(word, name);
        if (distance < least) {
            least = distance;
            nearest = name;
        }
    }
    return nearest;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> names) {
    const std::string name = nearest_name(word, names);
    return name.empty() ? "" : " (did you mean '" + name + "'?)";
}

void refuse_choice(std::string_view setting, std::string_view found, std::span<const std::string> names,
                   std::string_view or_else) {
    throw Error(ErrorCode::choice_unknown,
                fmt::format("{}: '{}' is unknown{}; choose one of: {}{}", setting, found, did_you_mean(found, names),
                            fmt::join(names, ", "), or_else),
                {setting});
}

}  // namespace vvr
