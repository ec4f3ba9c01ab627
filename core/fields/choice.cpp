#include "core/fields/choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"
#include "core/suggest.h"

namespace vvr {

void no_such_choice(std::string_view option, std::string_view found, const std::vector<std::string_view>& names,
                    std::string_view or_else) {
    const std::vector<std::string> all(names.begin(), names.end());
    throw Error(ErrorKind::usage, fmt::format("{}: there is no '{}'{}; it is one of: {}{}", option, found,
                                              did_you_mean(found, all), fmt::join(all, ", "), or_else));
}

}  // namespace vvr
