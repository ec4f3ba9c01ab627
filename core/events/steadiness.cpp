#include "core/events/steadiness.h"

#include <algorithm>
#include <cstdlib>
#include <span>

namespace vvr::events {

namespace {

constexpr int tolerance = 40;  // levels of a difference that is doubled: 20 grey levels
// A field as it was takes back half of one that was otherwise: what is otherwise every second time is not steady.
constexpr std::size_t miss = 2;
constexpr std::size_t at_once = 64;  // pixels; most of a field is nothing, and quickly known to be

bool nothing(std::span<const std::uint8_t> values) {
    std::uint8_t any = 0;
    for (const std::uint8_t value : values) any |= value;
    return any == 0;
}

}  // namespace

bool Steadiness::alike(std::uint8_t value, std::uint8_t level) {
    return value != 0 && std::abs(int{value} - int{level}) <= tolerance;
}

void Steadiness::add(const Plane<std::uint8_t>& field, const Moment& now) {
    if (pixels_.empty()) {
        pixels_ = Plane<Pixel>(field.size());
        levels_ = Plane<std::uint8_t>(field.size());
    }
    std::ranges::rotate(last_, last_.end() - 1);
    last_.front() = now;
    const auto values = field.pixels();
    const auto levels = levels_.pixels();
    for (std::size_t begin = 0; begin < values.size(); begin += at_once) {
        const std::size_t end = std::min(values.size(), begin + at_once);
        if (nothing(values.subspan(begin, end - begin)) && nothing(levels.subspan(begin, end - begin))) continue;
        for (std::size_t k = begin; k < end; ++k) {
            add(values[k], pixels_.pixels()[k], now);
            levels[k] = pixels_.pixels()[k].level;
        }
    }
}

void Steadiness::add(std::uint8_t value, Pixel& pixel, const Moment& now) const {
    if (value == 0 && pixel.level == 0) return;
    if (pixel.level != 0 && alike(value, pixel.level)) {
        // Follows light that changes slowly.
        pixel.level = static_cast<std::uint8_t>((7 * pixel.level + value + 4) / 8);
        if (pixel.misses > 0) pixel.misses--;
        return;
    }
    if (pixel.level == 0) {
        pixel = {.since = now, .level = value, .misses = 0};
    } else if (pixel.misses + miss >= miss * most_misses) {
        pixel = {.since = last_.back(), .level = value, .misses = 0};
    } else {
        pixel.misses = static_cast<std::uint8_t>(pixel.misses + miss);
    }
}

}  // namespace vvr::events
