#include "core/fields/illumination.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
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

constexpr std::array illumination_rows{
    IlluminationRow{"global", "one change for the whole picture: exposure, lamps; where much of it changes, as local",
                    true, 0.03},
    IlluminationRow{"local", "a change that varies over the picture: clouds, shadows, a lamp at one side", true, 0},
    IlluminationRow{"none", "compensate nothing", false, 0},
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

namespace {

/// Sums of products of the gradients of two pictures, around each block.
struct GradientProducts {
    cv::Mat frame;      ///< of the frame with itself
    cv::Mat reference;  ///< of the reference with itself
    cv::Mat both;
};

/// At half the size, which is enough for the texture and needs a quarter of the time.
cv::Mat halved(const Plane<std::uint8_t>& plane) {
    cv::Mat small;
    cv::resize(cv_view(plane), small, {(plane.width() + 1) / 2, (plane.height() + 1) / 2}, 0, 0, cv::INTER_AREA);
    small.convertTo(small, CV_32F);
    return small;
}

/// Means over each block, and then over its neighbours too.
cv::Mat around_blocks(const cv::Mat& plane, cv::Size grid) {
    cv::Mat means;
    cv::resize(plane, means, grid, 0, 0, cv::INTER_AREA);
    cv::blur(means, means, {3, 3}, {-1, -1}, cv::BORDER_REPLICATE);
    return means;
}

GradientProducts gradient_products(const cv::Mat& reference, const cv::Mat& frame, cv::Size grid) {
    GradientProducts sums;
    for (const auto& [across, down] : {std::pair(1, 0), std::pair(0, 1)}) {
        cv::Mat here;
        cv::Mat there;
        cv::Sobel(frame, here, CV_32F, across, down);
        cv::Sobel(reference, there, CV_32F, across, down);
        for (const auto& [a, b, sum] :
             {std::tuple(&here, &here, &sums.frame), std::tuple(&there, &there, &sums.reference),
              std::tuple(&here, &there, &sums.both)}) {
            const cv::Mat product = around_blocks(a->mul(*b), grid);
            *sum = sum->empty() ? product : cv::Mat(*sum + product);
        }
    }
    return sums;
}

}  // namespace

LocalLight local_light(const Planes& reference, const Planes& frame, const Plane<std::uint8_t>& object) {
    constexpr auto& t = thresholds.light;
    const cv::Size grid(std::max(1, frame.grey.width() / t.block), std::max(1, frame.grey.height() / t.block));
    const cv::Mat small_reference = halved(reference.grey);
    const cv::Mat small_frame = halved(frame.grey);
    const GradientProducts sums = gradient_products(small_reference, small_frame, grid);
    const cv::Mat before = around_blocks(small_reference, grid);
    const cv::Mat now = around_blocks(small_frame, grid);
    cv::Mat weights(grid, CV_32F, cv::Scalar(0));
    cv::Mat logs(grid, CV_32F, cv::Scalar(0));
    cv::Mat covered;
    cv::resize(cv_view(object) > 0, covered, grid, 0, 0, cv::INTER_AREA);
    int textured = 0;
    int explained = 0;
    for (int j = 0; j < grid.height; ++j) {
        for (int i = 0; i < grid.width; ++i) {
            const float texture = sums.reference.at<float>(j, i);
            if (texture < t.least_texture * t.least_texture) continue;
            const bool differs = covered.at<std::uint8_t>(j, i) > 127;
            textured += differs ? 1 : 0;
            const float similar =
                sums.both.at<float>(j, i) / std::sqrt(std::max(1.0F, texture * sums.frame.at<float>(j, i)));
            if (similar < t.same_texture) continue;
            const float gain = std::max(1.0F, now.at<float>(j, i)) / std::max(1.0F, before.at<float>(j, i));
            weights.at<float>(j, i) = 1;
            logs.at<float>(j, i) = std::log(gain);
            explained += differs ? 1 : 0;
        }
    }
    // Blocks that tell nothing get the change of those around them.
    cv::GaussianBlur(weights, weights, {}, t.reach);
    cv::GaussianBlur(logs, logs, {}, t.reach);
    LocalLight light{Plane<float>({grid.width, grid.height})};
    for (int j = 0; j < grid.height; ++j) {
        for (int i = 0; i < grid.width; ++i)
            light.gains.at(i, j) = std::exp(logs.at<float>(j, i) / std::max(0.02F, weights.at<float>(j, i)));
    }
    const int differing = cv::countNonZero(covered > 127);
    // Where few blocks have a texture, these tell too little.
    light.explained = 1.0 * explained / std::max({1, textured, differing / 2});
    light.changed = 1.0 * differing / grid.area();
    return light;
}

Planes relight(const Planes& picture, const LocalLight& light) {
    cv::Mat gains;
    cv::resize(cv_view(light.gains), gains, {picture.grey.width(), picture.grey.height()}, 0, 0, cv::INTER_LINEAR);
    return {times(picture.grey, gains), picture.colour.empty() ? Plane<Bgr>{} : times(picture.colour, gains)};
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

std::optional<Planes> relit(const Planes& reference, const Planes& frame, const IlluminationChange& light) {
    if (!light.is_visible()) return std::nullopt;
    Planes lit = relight(reference, light);
    if (light(255) < 255) {
        allow_for_clipping(reference.grey, frame.grey, lit.grey);
        allow_for_clipping(reference.colour, frame.colour, lit.colour);
    }
    return lit;
}

std::span<const IlluminationRow> illuminations() {
    return illumination_rows;
}

const IlluminationRow& row_of(Name<IlluminationRow> name) {
    return choose("illumination", name.text, illuminations());
}

}  // namespace vvr::fields
