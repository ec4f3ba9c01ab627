#include "core/events/steadiness.h"

#include <algorithm>
#include <cstdlib>

namespace vvr {

namespace {

constexpr int tolerance = 40;  // levels of a difference that is doubled: 20 grey levels
// A field as it was takes back half of one that was otherwise: what is otherwise every second time is not steady.
constexpr std::size_t miss = 2;

}  // namespace

bool Steadiness::alike(std::uint8_t value, std::uint8_t level) {
    return value != 0 && std::abs(int{value} - int{level}) <= tolerance;
}

void Steadiness::add(const Plane<std::uint8_t>& field, const Moment& now) {
    if (pixels_.empty()) pixels_ = Plane<Pixel>(field.size());
    std::ranges::rotate(last_, last_.end() - 1);
    last_.front() = now;
    const auto values = field.pixels();
    const auto pixels = pixels_.pixels();
    for (std::size_t k = 0; k < values.size(); ++k) {
        const std::uint8_t value = values[k];
        Pixel& pixel = pixels[k];
        if (value == 0 && pixel.level == 0) continue;
        if (pixel.level != 0 && alike(value, pixel.level)) {
            // Follows light that changes slowly.
            pixel.level = static_cast<std::uint8_t>((7 * pixel.level + value + 4) / 8);
            if (pixel.misses > 0) --pixel.misses;
            continue;
        }
        if (pixel.level == 0) {
            pixel = {.since = now, .level = value, .misses = 0};
        } else if (pixel.misses + miss >= miss * most_misses) {
            pixel = {.since = last_.back(), .level = value, .misses = 0};
        } else {
            pixel.misses = static_cast<std::uint8_t>(pixel.misses + miss);
        }
    }
}

}  // namespace vvr
