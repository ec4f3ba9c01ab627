#include "core/tracking/pixel_history.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <span>

#include "core/tracking/event_options.h"

namespace vvr::tracking {

namespace {

constexpr int once = 8;          // fixed-point 1
constexpr double fade_each = 1;  // seconds between two steps of the decay

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
    // Most of a field is 0: zeros are skipped eight pixels at a time.
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
    const int factor = static_cast<int>(256 * std::exp((faded_ - now.seconds) / thresholds.pixel.memory));
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

namespace {

// One field with the steady value makes up for half of one with another: so a pixel that alternates is not steady.
constexpr std::size_t miss = 2;
constexpr std::size_t at_once = 64;  // pixels that are skipped together where all are 0

bool nothing(std::span<const std::uint8_t> values) {
    std::uint8_t any = 0;
    for (const std::uint8_t value : values) any |= value;
    return any == 0;
}

}  // namespace

bool Steadiness::alike(std::uint8_t value, std::uint8_t level) {
    return value != 0 && std::abs(int{value} - int{level}) <= thresholds.pixel.level;
}

void Steadiness::add(const Plane<std::uint8_t>& field, const Moment& now) {
    if (pixels_.empty()) {
        pixels_ = Plane<Pixel>(field.size());
        levels_ = Plane<std::uint8_t>(field.size());
    }
    std::rotate(last_.begin(), last_.end() - 1, last_.end());
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
        // The level follows slow changes of light.
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

}  // namespace vvr::tracking
