#include "core/base/choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/error.h"
#include "core/base/suggest.h"

namespace vvr {

void refuse_choice(std::string_view setting, std::string_view found, std::span<const std::string> names,
                   std::string_view or_else) {
    throw Error(ErrorKind::usage,
                fmt::format("{}: there is no '{}'{}; it is one of: {}{}", setting, found, did_you_mean(found, names),
                            fmt::join(names, ", "), or_else),
                {setting});
}

}  // namespace vvr
