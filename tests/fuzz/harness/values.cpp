// Values of options: numbers, sizes, angles, times, lengths of time, shares.
#include "cli/options/parse_value.h"
#include "tests/fuzz/input.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace vvr;
    const std::string_view text = fuzz::text_of(data, size);
    constexpr Range range{-90, 360};
    if (const auto value = fuzz::parsed([&] { return options::parse_number(text, range); })) {
        fuzz::require(*value >= range.low && *value <= range.high, "a number is in its range");
    }
    if (const auto value = fuzz::parsed([&] { return options::parse_integer(text, -5, 5); })) {
        fuzz::require(*value >= -5 && *value <= 5, "so is a whole number");
    }
    if (const auto value = fuzz::parsed([&] { return options::parse_size(text); })) {
        fuzz::require(value->width >= 1 && value->height >= 1 && value->width <= 16384 && value->height <= 16384,
                      "a size");
    }
    for (const char separator : {',', ':'}) {
        if (const auto value = fuzz::parsed([&] { return options::parse_pair(text, separator, range, range); })) {
            fuzz::require(value->first >= range.low && value->second <= range.high, "so are two numbers");
        }
    }
    if (const auto value = fuzz::parsed([&] { return options::parse_duration(text); })) {
        fuzz::require(*value >= 0, "no time runs backwards");
    }
    if (const auto value = fuzz::parsed([&] { return options::parse_bytes(text); })) fuzz::require(*value > 0, "bytes");
    if (const auto value = fuzz::parsed([&] { return options::parse_share(text); })) {
        fuzz::require(value->first >= 1 && value->first <= value->second, "a share is one of all");
    }
    if (const auto value = fuzz::parsed([&] { return options::parse_time(text); }))
        fuzz::require(value->value >= 0, "a time");
    return 0;
}
