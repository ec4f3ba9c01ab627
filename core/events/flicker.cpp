#include "core/events/flicker.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace vvr::events {

namespace {

constexpr int once = 8;          // a count of one
constexpr double fade_each = 1;  // seconds

}  // namespace

void Flicker::add(const Plane<std::uint8_t>& field, const Moment& now) {
    if (before_.empty()) {
        before_ = field;
        counts_ = Plane<std::uint8_t>(field.size());
        faded_ = now.seconds;
        return;
    }
    const auto values = field.pixels();
    const auto before = before_.pixels();
    const auto counts = counts_.pixels();
    // Most of a field is nothing: eight pixels are passed over at a time.
    for (std::size_t k = 0; k < values.size(); k += 8) {
        const std::size_t end = std::min(values.size(), k + 8);
        std::uint64_t eight = 1;
        if (end == k + 8) std::memcpy(&eight, &values[k], 8);
        if (eight == 0) continue;
        for (std::size_t i = k; i < end; ++i) {
            if (values[i] != 0 && before[i] == 0)
                counts[i] = static_cast<std::uint8_t>(std::min(255, counts[i] + once));
        }
    }
    std::ranges::copy(values, before.begin());
    if (now.seconds - faded_ < fade_each) return;
    const int factor = static_cast<int>(256 * std::exp((faded_ - now.seconds) / memory_));
    for (std::uint8_t& count : counts) count = static_cast<std::uint8_t>(count * factor / 256);
    faded_ = now.seconds;
}

double Flicker::of(const Patch& patch) const {
    std::int64_t sum = 0;
    for_each_pixel(patch, [&](int i, int j, std::uint8_t) {
        if (i >= 0 && j >= 0 && i < counts_.width() && j < counts_.height()) sum += counts_.at(i, j);
    });
    return static_cast<double>(sum) / once / std::max(1, patch.area);
}

}  // namespace vvr::events
