#include "core/footage/piece_names.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/media/container.h"

namespace vvr::footage {

namespace {

constexpr std::string_view prefix = "event-";

}  // namespace

std::string piece_name(std::int64_t number, std::string_view extension) {
    return fmt::format("{}{}{}", prefix, number, extension);
}

bool is_piece_name(std::string_view name) {
    if (name == record_name || name == sums_name) return true;
    if (!name.starts_with(prefix)) return false;
    const std::string_view rest = name.substr(prefix.size());
    const std::size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
    constexpr std::size_t most_digits = 18;
    return digits > 0 && digits <= most_digits && rest[0] != '0' &&
           std::ranges::find(media::containers(), rest.substr(digits), &media::ContainerRow::name) !=
               media::containers().end();
}

}  // namespace vvr::footage
