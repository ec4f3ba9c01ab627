#include "core/tracking/appearance.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/tracking/event_options.h"

namespace vvr::tracking {

namespace {

constexpr int most_looks = 25;    // each later look has a weight of 1/25
constexpr int chroma_reach = 48;  // levels of blue or red from the brightness; few objects exceed them
constexpr int most_pixels = 300;  // larger patches are sampled to about this many pixels; more don't help

/// A value's bin. The share `rest` of it goes into the next bin, so that slightly brighter light doesn't change the
/// whole histogram.
struct Place {
    int bin = 0;
    float rest = 0;
};

/// The bins of all values from Low to High. The bins divide the range from `reach_low` to `reach_high` evenly; values
/// beyond it go into the outermost bins.
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

Appearance::Appearance(const Patch& patch, const FrameView& sight) : count_(1) {
    static_assert(bins == 8);
    std::array<float, parts> count{};
    const int height = std::max(1, patch.box.height());
    const int every = std::max(1, patch.area / most_pixels);
    int number = 0;
    for_each_pixel(patch, [&](int i, int j, std::uint8_t) {
        if (number++ % every != 0) return;
        const int part = std::clamp((j - patch.box.top) * parts / height, 0, parts - 1);
        const Bgr c = sight.at(i, j);
        const int brightness = fields::brightness_of(c);
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

void Appearance::learn(const Appearance& other) {
    if (other.count_ == 0) return;
    count_ = std::min(count_ + 1, most_looks);
    for (std::size_t k = 0; k < histogram_.size(); ++k) {
        histogram_[k] += (other.histogram_[k] - histogram_[k]) / static_cast<float>(count_);
    }
}

double distance(const Appearance& a, const Appearance& b) {
    if (!a.known() || !b.known()) return 0.5;
    double alike = 0;
    for (std::size_t k = 0; k < a.histogram_.size(); ++k) alike += std::sqrt(a.histogram_[k] * b.histogram_[k]);
    alike /= Appearance::parts * Appearance::channels;
    return std::sqrt(std::max(0.0, 1 - alike));
}

namespace {

constexpr int most_samples = 100;  // a larger template is sampled to about this many pixels

/// From 0 (nothing in common) to `thresholds.merged.unlike` (the same colour).
int similarity(const Bgr& a, const Bgr& b) {
    int most = 0;
    for (std::size_t c = 0; c < a.size(); ++c) most = std::max(most, std::abs(int{a[c]} - int{b[c]}));
    return std::max(0, thresholds.merged.unlike - most);
}

struct Sample {
    glm::ivec2 place;
    Bgr colour;
};

/// A pseudo-random sample of a template's pixels. A regular grid would miss shifts of one pixel.
std::vector<Sample> samples_of(const Template& object) {
    const auto every = static_cast<std::uint32_t>(std::max(1, object.patch.area / most_samples));
    std::vector<Sample> samples;
    std::uint32_t random = 1;
    for_each_pixel(object.patch, [&](int i, int j, std::uint8_t) {
        random = random * 1664525 + 1013904223;
        if ((random >> 16) % every != 0) return;
        samples.push_back({{i, j}, object.colours.at(i - object.patch.box.left, j - object.patch.box.top)});
    });
    return samples;
}

/// The blob's pixels that no object has claimed yet.
class UnclaimedPixels {
  public:
    explicit UnclaimedPixels(const Patch& blob) : rest_(blob) {}

    bool at(int i, int j) const { return rest_.at(i, j) != 0; }
    void take(int i, int j) {
        if (at(i, j)) rest_.values.at(i - rest_.box.left, j - rest_.box.top) = 0;
    }

  private:
    Patch rest_;
};

struct Match {
    glm::ivec2 shift{};
    double score = -std::numeric_limits<double>::infinity();
    double similarity = 0;
};

Match place_at(const std::vector<Sample>& samples, const FrameView& sight, const Patch& blob,
               const UnclaimedPixels& free, const glm::ivec2& expected, const glm::ivec2& off) {
    int sum = 0;
    int against = 0;
    for (const Sample& sample : samples) {
        const glm::ivec2 p = sample.place + expected + off;
        // A pixel on the blob may be occluded. A pixel beside the blob contradicts the match.
        if (blob.at(p.x, p.y) == 0) against += thresholds.merged.unlike / 8;
        if (free.at(p.x, p.y)) sum += similarity(sight.at(p.x, p.y), sample.colour);
    }
    const double all =
        static_cast<double>(thresholds.merged.unlike) * static_cast<double>(std::max<std::size_t>(1, samples.size()));
    const double part = sum / all;
    return {expected + off, part - against / all - thresholds.merged.astray * (off.x * off.x + off.y * off.y), part};
}

/// Searches every second pixel first, then the neighbours of the best.
Match best_match(const std::vector<Sample>& samples, const FrameView& sight, const Patch& blob,
                 const UnclaimedPixels& free, const glm::ivec2& expected) {
    Match best;
    glm::ivec2 best_off{};
    const auto look = [&](const glm::ivec2& off) {
        const Match place = place_at(samples, sight, blob, free, expected, off);
        if (place.score <= best.score) return;
        best = place;
        best_off = off;
    };
    for (int y = -thresholds.merged.search; y <= thresholds.merged.search; y += 2) {
        for (int x = -thresholds.merged.search; x <= thresholds.merged.search; x += 2) look({x, y});
    }
    const glm::ivec2 middle = best_off;
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) look(middle + glm::ivec2(x, y));
    }
    return best;
}

void take_own(const Template& object, const glm::ivec2& shift, const FrameView& sight, UnclaimedPixels& free) {
    for_each_pixel(object.patch, [&](int i, int j, std::uint8_t) {
        const glm::ivec2 p(i + shift.x, j + shift.y);
        if (!free.at(p.x, p.y)) return;
        const Bgr& colour = object.colours.at(i - object.patch.box.left, j - object.patch.box.top);
        if (similarity(sight.at(p.x, p.y), colour) >= thresholds.merged.unlike / 2) free.take(p.x, p.y);
    });
}

/// Gives each pixel of the blob to the object whose template matches it best, or else to the nearest object.
void split_pixels(const Patch& blob, const FrameView& sight, std::span<const Template* const> templates,
                  std::vector<TemplateMatch>& shares) {
    for (TemplateMatch& share : shares)
        share.patch = {.box = blob.box, .values = Plane<std::uint8_t>(blob.values.size())};
    for_each_pixel(blob, [&](int i, int j, std::uint8_t value) {
        const Bgr colour = sight.at(i, j);
        double most = -std::numeric_limits<double>::infinity();
        TemplateMatch* owner = nullptr;
        for (std::size_t k = 0; k < shares.size(); ++k) {
            const Patch& patch = templates[k]->patch;
            const glm::ivec2 p = glm::ivec2(i, j) - shares[k].shift;
            double score = 0;
            if (patch.at(p.x, p.y) != 0) {
                score = 1 + similarity(colour, templates[k]->colours.at(p.x - patch.box.left, p.y - patch.box.top));
            } else {
                const glm::dvec2 half(0.5 * patch.box.width() + 1, 0.5 * patch.box.height() + 1);
                score = -glm::length((glm::dvec2(p) - patch.centre) / half);
            }
            if (score <= most) continue;
            most = score;
            owner = &shares[k];
        }
        if (owner == nullptr) return;
        owner->patch.values.at(i - blob.box.left, j - blob.box.top) = value;
        owner->patch.centre += glm::dvec2(i, j);
        ++owner->patch.area;
    });
    for (TemplateMatch& share : shares) share.patch.centre /= std::max(1, share.patch.area);
}

}  // namespace

Template::Template(Patch of, const FrameView& sight)
    : patch(std::move(of)), colours(Plane<Bgr>::for_overwrite(patch.values.size())) {
    for (int j = 0; j < colours.height(); ++j) {
        for (int i = 0; i < colours.width(); ++i) colours.at(i, j) = sight.at(patch.box.left + i, patch.box.top + j);
    }
}

std::vector<TemplateMatch> split_blob(const Patch& blob, const FrameView& sight,
                                      std::span<const Template* const> templates,
                                      std::span<const glm::ivec2> expected) {
    const std::size_t count = templates.size();
    std::vector<TemplateMatch> shares(count);
    std::vector<std::vector<Sample>> samples(count);
    for (std::size_t k = 0; k < count; ++k) samples[k] = samples_of(*templates[k]);
    std::vector<bool> placed(count);
    UnclaimedPixels free(blob);
    for (std::size_t turn = 0; turn < count; ++turn) {
        Match best;
        std::size_t next = count;
        for (std::size_t k = 0; k < count; ++k) {
            if (placed[k]) continue;
            const Match place = best_match(samples[k], sight, blob, free, expected[k]);
            if (next != count && place.score <= best.score) continue;
            best = place;
            next = k;
        }
        placed[next] = true;
        shares[next].shift = best.shift;
        shares[next].similarity = best.similarity;
        take_own(*templates[next], best.shift, sight, free);
    }
    split_pixels(blob, sight, templates, shares);
    return shares;
}

}  // namespace vvr::tracking
