#include "core/fields/illumination.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"
#include "core/base/setting.h"
#include "core/fields/options.h"
#include "core/fields/thresholds.h"

namespace vvr::fields {
namespace {

/// A weighted sample.
struct Vote {
    double value;
    double weight;
};

/// The value below which half of the weight lies.
double weighted_median(std::vector<Vote>& votes) {
    std::ranges::sort(votes, {}, &Vote::value);
    double half = 0;
    for (const Vote& vote : votes) half += vote.weight / 2;
    for (const Vote& vote : votes) {
        half -= vote.weight;
        if (half <= 0) return vote.value;
    }
    return votes.back().value;
}

/// The levels in the frame of the reference's pixels of some neighbouring levels.
class LevelChange {
  public:
    void add(std::uint8_t before, std::uint8_t now) {
        ++counts_[now];
        sum_ += before;
        ++total_;
    }

    int total() const { return total_; }
    double before() const { return static_cast<double>(sum_) / total_; }

    /// The median level in the frame, interpolated as if pixels of one level were spread evenly over it.
    double now() const {
        int below = 0;
        std::size_t level = 0;
        while (2 * (below + counts_[level]) < total_) below += counts_[level++];
        return static_cast<double>(level) - 0.5 + (total_ / 2.0 - below) / counts_[level];
    }

  private:
    std::array<int, 256> counts_{};
    std::int64_t sum_ = 0;
    int total_ = 0;
};

/// The change of a picture's levels, in classes of neighbouring levels.
std::vector<LevelChange> level_changes(const Planes& reference, const Planes& frame) {
    std::vector<LevelChange> classes(256 / thresholds.light.levels_per_class);
    for (int j = 0; j < frame.grey.height(); j += thresholds.sampling) {
        for (int i = 0; i < frame.grey.width(); i += thresholds.sampling) {
            const std::uint8_t before = reference.grey.at(i, j);
            const std::uint8_t now = frame.grey.at(i, j);
            if (before < thresholds.light.darkest || before > thresholds.light.brightest ||
                now < thresholds.light.darkest || now > thresholds.light.brightest)
                continue;
            classes[before / thresholds.light.levels_per_class].add(before, now);
        }
    }
    std::erase_if(classes, [](const LevelChange& c) { return c.total() < thresholds.light.fewest; });
    return classes;
}

/// One class: its mean level in the reference, and its level in the frame.
struct Change {
    double before;
    double now;
    double weight;
};

// Robust line fit after Theil (1950) and Sen (1968): the median of the slopes between all pairs of points, then the
// median of the residuals. A few outliers don't change it.
IlluminationChange line_through(std::span<const Change> changes) {
    std::vector<Vote> slopes;
    for (const Change& a : changes) {
        for (const Change& b : changes) {
            const double distance = b.before - a.before;
            if (distance < thresholds.light.least_distance) continue;
            slopes.push_back({(b.now - a.now) / distance, std::sqrt(a.weight * b.weight) * distance});
        }
    }
    // In a picture of one level, a gain and an offset look the same; either is fine.
    IlluminationChange light;
    if (!slopes.empty())
        light.gain = std::clamp(weighted_median(slopes), thresholds.light.least_gain, thresholds.light.most_gain);
    std::vector<Vote> offsets;
    for (const Change& c : changes) offsets.push_back({c.now - light.gain * c.before, c.weight});
    light.offset = weighted_median(offsets);
    return light;
}

template <class T>
Plane<T> relight_plane(const Plane<T>& plane, const IlluminationChange& light) {
    auto result = Plane<T>::for_overwrite(plane.size());
    // Arithmetic needs a quarter of the time of a lookup table.
    cv::Mat out = cv_view(result);
    cv_view(plane).convertTo(out, out.type(), light.gain, light.offset);
    return result;
}

std::optional<Planes> unchanged(const Planes&, const Planes&, const IlluminationChange&) {
    return std::nullopt;
}

std::span<const std::uint8_t> bytes(const Plane<std::uint8_t>& plane) {
    return plane.pixels();
}
std::span<const std::uint8_t> bytes(const Plane<Bgr>& plane) {
    return {plane.pixels().front().data(), plane.pixels().size() * 3};
}

// A clipped pixel may have had any brightness beyond the limit: it gets the brighter of its relit value and its value
// in the frame.
template <class T>
void allow_for_clipping(const Plane<T>& reference, const Plane<T>& frame, Plane<T>& lit) {
    if (reference.empty() || frame.empty()) return;
    const std::span<const std::uint8_t> before = bytes(reference);
    const std::span<const std::uint8_t> now = bytes(frame);
    auto* const out = reinterpret_cast<std::uint8_t*>(lit.pixels().data());
    for (std::size_t i = 0; i < before.size(); ++i) {
        const std::uint8_t brighter = std::max(out[i], now[i]);
        out[i] = before[i] > thresholds.light.cut_off ? brighter : out[i];
    }
}

std::optional<Planes> relit_globally(const Planes& reference, const Planes& frame, const IlluminationChange& light) {
    if (!light.is_visible()) return std::nullopt;
    Planes lit = relight(reference, light);
    if (light(255) < 255) {
        allow_for_clipping(reference.grey, frame.grey, lit.grey);
        allow_for_clipping(reference.colour, frame.colour, lit.colour);
    }
    return lit;
}

// The median ratio of grey levels around each block. It must also agree with its neighbours', so that a coat isn't
// taken for a shadow.
Plane<float> local_gains(const Planes& reference, const Planes& frame) {
    constexpr int block = thresholds.light.block;
    const Size size = frame.grey.size();
    Plane<float> gains({(size.width + block - 1) / block, (size.height + block - 1) / block});
    std::vector<Vote> ratios;
    for (int j = 0; j < gains.height(); ++j) {
        for (int i = 0; i < gains.width(); ++i) {
            // With a margin of half a block on each side.
            const cv::Rect window = cv::Rect(i * block - block / 2, j * block - block / 2, 2 * block, 2 * block) &
                                    cv::Rect(0, 0, size.width, size.height);
            ratios.clear();
            for (int y = window.y; y < window.y + window.height; y += thresholds.sampling) {
                for (int x = window.x; x < window.x + window.width; x += thresholds.sampling) {
                    const double before = std::max<int>(reference.grey.at(x, y), thresholds.light.darkest);
                    // Brighter pixels give more precise ratios.
                    ratios.push_back({std::max<int>(frame.grey.at(x, y), thresholds.light.darkest) / before, before});
                }
            }
            gains.at(i, j) = static_cast<float>(std::clamp(
                weighted_median(ratios), 1 / thresholds.light.most_local_change, thresholds.light.most_local_change));
        }
    }
    Plane<float> smooth(gains.size());
    cv::Mat out = cv_view(smooth);
    cv::medianBlur(cv_view(gains), out, 5);
    return smooth;
}

template <class T>
Plane<T> times(const Plane<T>& plane, const cv::Mat& gains) {
    constexpr std::size_t channels = std::is_same_v<T, Bgr> ? 3 : 1;
    cv::Mat gains_of_channels;
    cv::merge(std::vector<cv::Mat>(channels, gains), gains_of_channels);
    auto result = Plane<T>::for_overwrite(plane.size());
    cv::Mat out = cv_view(result);
    cv::multiply(cv_view(plane), gains_of_channels, out, 1, out.type());
    return result;
}

std::optional<Planes> relit_locally(const Planes& reference, const Planes& frame, const IlluminationChange& light) {
    const std::optional<Planes> globally = relit_globally(reference, frame, light);
    const Planes& lit = globally ? *globally : reference;
    const Plane<float> blocks = local_gains(lit, frame);
    constexpr int block = thresholds.light.block;
    // Blocks may extend beyond the picture: the gains are enlarged, then cropped.
    cv::Mat gains;
    cv::resize(cv_view(blocks), gains, {blocks.width() * block, blocks.height() * block}, 0, 0, cv::INTER_LINEAR);
    gains = gains(cv::Rect(0, 0, frame.grey.width(), frame.grey.height())).clone();
    return Planes{times(lit.grey, gains), lit.colour.empty() ? Plane<Bgr>{} : times(lit.colour, gains)};
}

constexpr std::array illumination_rows{
    IlluminationRow{"global", "one change for the whole picture: exposure, clouds, lamps", true, relit_globally},
    IlluminationRow{"local", "a change that varies over the picture: shadows, a lamp at one side", true, relit_locally},
    IlluminationRow{"none", "compensate nothing", false, unchanged},
};

}  // namespace

IlluminationChange estimate_illumination(const Planes& reference, const Planes& frame) {
    const std::vector<LevelChange> classes = level_changes(reference, frame);
    int used = 0;
    for (const LevelChange& c : classes) used += c.total();
    // If nearly all pixels are clipped, nothing can be learnt.
    const int sampled = ((frame.grey.width() + thresholds.sampling - 1) / thresholds.sampling) *
                        ((frame.grey.height() + thresholds.sampling - 1) / thresholds.sampling);
    if (used == 0 || 5 * used < sampled) return {};
    std::vector<Change> changes;
    for (const LevelChange& c : classes) changes.push_back({c.before(), c.now(), 1.0 * c.total()});
    return line_through(changes);
}

Quantiles quantiles_of(const Plane<std::uint8_t>& grey) {
    std::array<int, 256> counts{};
    int total = 0;
    for (int j = 0; j < grey.height(); j += thresholds.sampling) {
        for (int i = 0; i < grey.width(); i += thresholds.sampling) ++counts[grey.at(i, j)];
        total += (grey.width() + thresholds.sampling - 1) / thresholds.sampling;
    }
    Quantiles quantiles{};
    int below = 0;
    std::size_t level = 0;
    for (std::size_t k = 0; k < quantiles.size(); ++k) {
        const float wanted = static_cast<float>(total) * static_cast<float>(k + 1) / 20;
        while (static_cast<float>(below + counts[level]) < wanted) below += counts[level++];
        // Interpolates as if pixels of one level were spread evenly over it.
        const float part = (wanted - static_cast<float>(below)) / static_cast<float>(counts[level]);
        quantiles[k] = static_cast<float>(level) - 0.5F + part;
    }
    return quantiles;
}

bool illumination_jumps(const Quantiles& from, const Quantiles& to) {
    std::size_t changed = 0;
    for (std::size_t k = 0; k < from.size(); ++k)
        changed += std::abs(to[k] - from[k]) >= thresholds.light.jump ? 1U : 0U;
    return 2 * changed > from.size();
}

Planes relight(const Planes& picture, const IlluminationChange& light) {
    if (!light.is_visible()) return picture;
    return {relight_plane(picture.grey, light),
            picture.colour.empty() ? Plane<Bgr>{} : relight_plane(picture.colour, light)};
}

std::span<const IlluminationRow> illuminations() {
    return illumination_rows;
}

const IlluminationRow& row_of(Name<IlluminationRow> name) {
    return choose("illumination", name.text, illuminations());
}

}  // namespace vvr::fields
