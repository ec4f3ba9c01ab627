// Values of options: numbers, sizes, angles, times, lengths of time, shares.
#include "cli/options/parse_value.h"
#include "tests/fuzz/input.h"

void vvr::fuzz::check(std::string_view text) {
    constexpr Range range{-90, 360};
    if (const auto value = parsed([&] { return options::parse_number(text, range); })) {
        require(*value >= range.low && *value <= range.high, "a number is in its range");
    }
    if (const auto value = parsed([&] { return options::parse_integer(text, -5, 5); })) {
        require(*value >= -5 && *value <= 5, "so is a whole number");
    }
    if (const auto value = parsed([&] { return options::parse_size(text); })) {
        require(value->width >= 1 && value->height >= 1 && value->width <= 16384 && value->height <= 16384, "a size");
    }
    for (const char separator : {',', ':'}) {
        if (const auto value = parsed([&] { return options::parse_pair(text, separator, range, range); })) {
            require(value->first >= range.low && value->second <= range.high, "so are two numbers");
        }
    }
    if (const auto value = parsed([&] { return options::parse_duration(text); })) {
        require(*value >= 0, "no time runs backwards");
    }
    if (const auto value = parsed([&] { return options::parse_bytes(text); })) require(*value > 0, "bytes");
    if (const auto value = parsed([&] { return options::parse_share(text); })) {
        require(value->first >= 1 && value->first <= value->second, "a share is one of all");
    }
    if (const auto value = parsed([&] { return options::parse_time(text); })) require(value->value >= 0, "a time");
}
