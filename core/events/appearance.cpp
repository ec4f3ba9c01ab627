#include "core/events/appearance.h"

#include <algorithm>
#include <cmath>

namespace vvr::events {

namespace {

constexpr int most_looks = 25;    // then each look counts for a 25th
constexpr int chroma_reach = 48;  // levels of blue or red above or below the brightness; few things go beyond
constexpr int most_pixels = 300;  // of a patch that are counted, at least; more tell no more

/// The bin of a value, of which the rest falls into the next one: so a little more light does not change everything.
struct Place {
    int bin = 0;
    float rest = 0;
};

/// The places of values from `low` to `high`, which share `bins` bins evenly; what lies beyond is in the outermost.
template <int Low, int High, int Bins>
constexpr auto places_of_values(int reach_low, int reach_high) {
    std::array<Place, static_cast<std::size_t>(High - Low + 1)> places{};
    for (int value = Low; value <= High; ++value) {
        const float part = (static_cast<float>(value - reach_low) + 0.5F) / static_cast<float>(reach_high - reach_low);
        const float place = std::clamp(part * Bins - 0.5F, 0.0F, Bins - 1.001F);
        const int bin = static_cast<int>(place);
        places[static_cast<std::size_t>(value - Low)] = {bin, place - static_cast<float>(bin)};
    }
    return places;
}

constexpr auto brightness_places = places_of_values<0, 255, 8>(0, 256);
constexpr auto chroma_places = places_of_values<-255, 255, 8>(-chroma_reach, chroma_reach);

}  // namespace

Appearance::Appearance(const Patch& patch, const FrameView& sight) : looks_(1) {
    static_assert(bins == 8);
    std::array<float, parts> count{};
    const int height = std::max(1, patch.box.height());
    const int every = std::max(1, patch.area / most_pixels);
    int number = 0;
    for_each_pixel(patch, [&](int i, int j, std::uint8_t) {
        if (number++ % every != 0) return;
        const int part = std::clamp((j - patch.box.top) * parts / height, 0, parts - 1);
        const Bgr c = sight.at(i, j);
        const int brightness = (c[0] + 2 * c[1] + c[2]) / 4;
        const std::array<const Place*, channels> places{
            &brightness_places[static_cast<std::size_t>(brightness)],
            &chroma_places[static_cast<std::size_t>(c[0] - brightness + 255)],
            &chroma_places[static_cast<std::size_t>(c[2] - brightness + 255)]};
        for (int k = 0; k < channels; ++k) {
            const Place& place = *places[static_cast<std::size_t>(k)];
            const auto base = static_cast<std::size_t>((part * channels + k) * bins + place.bin);
            histogram_[base] += 1 - place.rest;
            histogram_[base + 1] += place.rest;
        }
        count[static_cast<std::size_t>(part)] += 1;
    });
    for (std::size_t k = 0; k < histogram_.size(); ++k) {
        const float all = count[k / static_cast<std::size_t>(channels * bins)];
        if (all > 0) histogram_[k] /= all;
    }
}

void Appearance::learn(const Appearance& look) {
    if (look.looks_ == 0) return;
    looks_ = std::min(looks_ + 1, most_looks);
    for (std::size_t k = 0; k < histogram_.size(); ++k) {
        histogram_[k] += (look.histogram_[k] - histogram_[k]) / static_cast<float>(looks_);
    }
}

double distance(const Appearance& a, const Appearance& b) {
    if (!a.known() || !b.known()) return 0.5;
    double alike = 0;
    for (std::size_t k = 0; k < a.histogram_.size(); ++k) alike += std::sqrt(a.histogram_[k] * b.histogram_[k]);
    alike /= Appearance::parts * Appearance::channels;
    return std::sqrt(std::max(0.0, 1 - alike));
}

}  // namespace vvr::events
