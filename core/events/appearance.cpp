#include "core/events/appearance.h"

#include <algorithm>
#include <cmath>

namespace vvr {

namespace {

constexpr int most_looks = 25;      // then each look counts for a 25th
constexpr float chroma_reach = 48;  // levels of blue or red above or below the brightness; few things go beyond

}  // namespace

Appearance::Appearance(const Patch& patch, const Sight& sight) : looks_(1) {
    std::array<float, parts> count{};
    const int height = std::max(1, patch.box.height());
    for_each_pixel(patch, [&](int i, int j, std::uint8_t) {
        const int part = std::clamp((j - patch.box.top) * parts / height, 0, parts - 1);
        const Bgr c = sight.at(i, j);
        const float brightness = static_cast<float>(c[0] + 2 * c[1] + c[2]) / 4;
        const std::array<float, channels> values{brightness / 256,
                                                 0.5F + (static_cast<float>(c[0]) - brightness) / (2 * chroma_reach),
                                                 0.5F + (static_cast<float>(c[2]) - brightness) / (2 * chroma_reach)};
        for (int k = 0; k < channels; ++k) {
            // Shared by the two nearest bins, so that a little more light does not change everything.
            const float place = std::clamp(values[static_cast<std::size_t>(k)] * bins - 0.5F, 0.0F, bins - 1.001F);
            const int bin = static_cast<int>(place);
            const float rest = place - static_cast<float>(bin);
            const auto base = static_cast<std::size_t>((part * channels + k) * bins + bin);
            shares_[base] += 1 - rest;
            shares_[base + 1] += rest;
        }
        count[static_cast<std::size_t>(part)] += 1;
    });
    for (std::size_t k = 0; k < shares_.size(); ++k) {
        const float all = count[k / static_cast<std::size_t>(channels * bins)];
        if (all > 0) shares_[k] /= all;
    }
}

void Appearance::learn(const Appearance& look) {
    if (look.looks_ == 0) return;
    looks_ = std::min(looks_ + 1, most_looks);
    for (std::size_t k = 0; k < shares_.size(); ++k) {
        shares_[k] += (look.shares_[k] - shares_[k]) / static_cast<float>(looks_);
    }
}

double distance(const Appearance& a, const Appearance& b) {
    if (!a.known() || !b.known()) return 0.5;
    double alike = 0;
    for (std::size_t k = 0; k < a.shares_.size(); ++k) alike += std::sqrt(a.shares_[k] * b.shares_[k]);
    alike /= Appearance::parts * Appearance::channels;
    return std::sqrt(std::max(0.0, 1 - alike));
}

}  // namespace vvr
