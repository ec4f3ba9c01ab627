#include "core/fields/field.h"

namespace vvr::fields {

std::optional<SeedFlags> SeedFlags::parse(std::string_view digits) {
    if (digits.empty() || digits.size() > most) return std::nullopt;
    if (digits.find_first_not_of("01") != std::string_view::npos) return std::nullopt;
    SeedFlags flags;
    flags.digits_ = 0;
    flags.count_ = static_cast<int>(digits.size());
    for (std::size_t i = 0; i < digits.size(); ++i) flags.digits_ |= (digits[i] == '1' ? 1U : 0U) << i;
    return flags;
}

std::string SeedFlags::text() const {
    std::string digits;
    for (int i = 0; i < count_; ++i) digits += in(i) ? '1' : '0';
    return digits;
}

}  // namespace vvr::fields
