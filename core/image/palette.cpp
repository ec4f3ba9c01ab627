#include "core/image/palette.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace vvr::image {

namespace {

constexpr std::size_t most_colours = 256;
// Upper bits per channel. Colours with the same upper bits are treated as one.
constexpr int bits = 6;

int level(float value) {
    return static_cast<int>(std::lround(255 * std::clamp(value, 0.0F, 1.0F)));
}

std::array<int, 3> levels(const Rgba& pixel) {
    return {level(pixel.r), level(pixel.g), level(pixel.b)};
}

std::size_t bin_of(const std::array<int, 3>& colour) {
    std::size_t bin = 0;
    for (const int of : colour) bin = (bin << bits) | static_cast<std::size_t>(of >> (8 - bits));
    return bin;
}

struct Entry {
    std::array<double, 3> colour{};
    double pixels = 0;
};

std::vector<Entry> histogram(const Picture& picture) {
    std::vector<Entry> bins(std::size_t{1} << (3 * bits));
    for (const Rgba& pixel : picture.pixels.pixels()) {
        const std::array<int, 3> colour = levels(pixel);
        Entry& bin = bins[bin_of(colour)];
        for (std::size_t c = 0; c < 3; ++c) bin.colour[c] += colour[c];
        ++bin.pixels;
    }
    std::erase_if(bins, [](const Entry& bin) { return bin.pixels == 0; });
    for (Entry& bin : bins) {
        for (double& value : bin.colour) value /= bin.pixels;
    }
    return bins;
}

/// A box of colours, which one palette colour represents.
struct Box {
    std::span<Entry> entries;
    std::array<double, 3> mean{};
    std::size_t widest = 0;
    double error = 0;  ///< squared error along the channel where it is largest

    explicit Box(std::span<Entry> inside) : entries(inside) {
        double pixels = 0;
        std::array<double, 3> squares{};
        for (const Entry& entry : entries) {
            // The square root leaves colours for small objects in front of a large plain background.
            const double weight = std::sqrt(entry.pixels);
            pixels += weight;
            for (std::size_t c = 0; c < 3; ++c) {
                mean[c] += weight * entry.colour[c];
                squares[c] += weight * entry.colour[c] * entry.colour[c];
            }
        }
        for (std::size_t c = 0; c < 3; ++c) {
            mean[c] /= pixels;
            squares[c] -= pixels * mean[c] * mean[c];
        }
        widest = static_cast<std::size_t>(std::ranges::max_element(squares) - squares.begin());
        error = entries.size() > 1 ? squares[widest] : 0;
    }
};

}  // namespace

Palette::Palette(const Picture& picture) : known_(std::size_t{1} << (3 * bits), -1) {
    std::vector<Entry> entries = histogram(picture);
    std::vector<Box> boxes = {Box(entries)};
    while (boxes.size() < most_colours) {
        const auto worst = std::ranges::max_element(boxes, {}, &Box::error);
        if (worst->error <= 0) break;
        const std::size_t c = worst->widest;
        const auto upper = std::ranges::partition(
            worst->entries, [cut = worst->mean[c], c](const Entry& entry) { return entry.colour[c] <= cut; });
        const auto lower = worst->entries.first(worst->entries.size() - upper.size());
        if (lower.empty() || upper.empty()) break;
        *worst = Box(lower);
        boxes.push_back(Box(upper));
    }
    for (const Box& box : boxes) {
        Colour colour;
        std::ranges::transform(box.mean, colour.begin(),
                               [](double value) { return static_cast<std::uint8_t>(std::lround(value)); });
        colours_.push_back(colour);
    }
}

std::uint8_t Palette::nearest(const Rgba& pixel) {
    const std::array<int, 3> colour = levels(pixel);
    int& answer = known_[bin_of(colour)];
    if (answer < 0) {
        int least = std::numeric_limits<int>::max();
        for (std::size_t i = 0; i < colours_.size(); ++i) {
            int away = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const int step = colours_[i][c] - colour[c];
                away += step * step;
            }
            if (away < least) {
                least = away;
                answer = static_cast<int>(i);
            }
        }
    }
    return static_cast<std::uint8_t>(answer);
}

}  // namespace vvr::image
