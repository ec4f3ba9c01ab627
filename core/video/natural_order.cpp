#include "core/video/natural_order.h"

#include <algorithm>

namespace vvr::video {
namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Cuts the run of digits off the front of `text`, without its leading zeros.
std::string_view take_number(std::string_view& text) {
    const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
    const auto first = std::find_if(text.begin(), end, [](char c) { return c != '0'; });
    const std::string_view number(first, end);
    text.remove_prefix(static_cast<std::size_t>(end - text.begin()));
    return number;
}

}  // namespace

bool natural_less(std::string_view a, std::string_view b) {
    std::string_view rest_a = a;
    std::string_view rest_b = b;
    while (!rest_a.empty() && !rest_b.empty()) {
        if (is_digit(rest_a.front()) && is_digit(rest_b.front())) {
            const auto number_a = take_number(rest_a);
            const auto number_b = take_number(rest_b);
            if (number_a.size() != number_b.size()) return number_a.size() < number_b.size();
            if (number_a != number_b) return number_a < number_b;
        } else {
            if (rest_a.front() != rest_b.front()) return rest_a.front() < rest_b.front();
            rest_a.remove_prefix(1);
            rest_b.remove_prefix(1);
        }
    }
    if (rest_a.empty() != rest_b.empty()) return rest_a.empty();
    return a < b;
}

}  // namespace vvr::video
