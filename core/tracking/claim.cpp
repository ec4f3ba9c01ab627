#include "core/tracking/claim.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"
#include "core/tracking/event_options.h"

namespace vvr::tracking {

namespace {

/// The confidence of a term that must be at least `least`: 0.5 there, 1 from twice that on.
double at_least(double value, double least) {
    return std::clamp(value / (2 * least), 0.0, 1.0);
}

/// The confidence of a term that must be at most `most`: 0.5 there, 0 from twice that on.
double at_most(double value, double most) {
    return 1 - at_least(value, most);
}

fields::Planes part_of_scene(const fields::Planes& scene, const PixelBox& box) {
    return {cropped(scene.grey, box), scene.colour.empty() ? Plane<Bgr>() : cropped(scene.colour, box)};
}

/// The connected component of the pixels above a level that holds most of the settled ones; nothing where they share
/// too few pixels.
std::optional<Patch> region_at(const cv::Mat& difference, int level, const Patch& settled, const PixelBox& box) {
    cv::Mat labels;
    cv::connectedComponents(difference > level, labels, 8, CV_32S);
    std::vector<int> shared;
    for_each_pixel(settled, [&](int i, int j, std::uint8_t) {
        const int label = labels.at<int>(j - box.top, i - box.left);
        if (label == 0) return;
        shared.resize(std::max(shared.size(), static_cast<std::size_t>(label) + 1));
        ++shared[static_cast<std::size_t>(label)];
    });
    if (shared.empty()) return std::nullopt;
    const auto most = std::ranges::max_element(shared);
    const int label = static_cast<int>(most - shared.begin());
    Patch all{.box = box, .values = Plane<std::uint8_t>(box.size(), 255)};
    Patch region = part_of(all, [&](int i, int j) { return labels.at<int>(j - box.top, i - box.left) == label; });
    if (*most < thresholds.most * std::min(region.area, settled.area)) return std::nullopt;
    return region;
}

/// The largest distance to the outline / half of the longer side of the region's box.
double thickness_of(const Patch& region) {
    PixelBox box;
    for_each_pixel(region, [&](int i, int j, std::uint8_t) { box = bounding_box(box, {i, j, i + 1, j + 1}); });
    cv::Mat inside;
    cv::copyMakeBorder(cv_view(region.values), inside, 1, 1, 1, 1, cv::BORDER_CONSTANT, 0);
    cv::Mat distance;
    cv::distanceTransform(inside, distance, cv::DIST_L2, 3);
    double deepest = 0;
    cv::minMaxLoc(distance, nullptr, &deepest);
    return 2 * deepest / std::max({1, box.width(), box.height()});
}

/// The median difference of a channel, outside of the settled pixels: a change of light.
int offset_of(const fields::Planes& mean, const fields::Planes& empty, std::size_t channel, const Patch& settled,
              const PixelBox& box) {
    std::vector<int> differences;
    for (int j = 0; j < box.height(); ++j) {
        for (int i = 0; i < box.width(); ++i) {
            if (settled.at(box.left + i, box.top + j) != 0) continue;
            differences.push_back(empty.colour.empty()
                                      ? mean.grey.at(i, j) - empty.grey.at(i, j)
                                      : mean.colour.at(i, j)[channel] - empty.colour.at(i, j)[channel]);
        }
    }
    if (differences.empty()) return 0;
    const auto middle = differences.begin() + std::ssize(differences) / 2;
    std::ranges::nth_element(differences, middle);
    return *middle;
}

/// Gives the mean picture the light of the empty scene.
void match_light(fields::Planes& mean, const fields::Planes& empty, const Patch& settled, const PixelBox& box) {
    const auto shift = [](std::uint8_t& value, int by) {
        value = static_cast<std::uint8_t>(std::clamp(value - by, 0, 255));
    };
    if (mean.colour.empty()) {
        const int by = offset_of(mean, empty, 0, settled, box);
        for (std::uint8_t& value : mean.grey.pixels()) shift(value, by);
        return;
    }
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const int by = offset_of(mean, empty, channel, settled, box);
        for (Bgr& colour : mean.colour.pixels()) shift(colour[channel], by);
    }
}

}  // namespace

StillPicture::StillPicture(const Patch& patch, Size field) {
    const int length = std::max({2, patch.box.width(), patch.box.height()});
    box_ = intersection(patch.box.inflated(length, length), {0, 0, field.width, field.height});
    sum_.resize(static_cast<std::size_t>(box_.width()) * static_cast<std::size_t>(box_.height()));
}

void StillPicture::add(const FrameView& frame, const Moment& now) {
    if (box_.empty() || (count_ > 0 && now.seconds < due_)) return;
    due_ = now.seconds + thresholds.claim.sampled;
    ++count_;
    auto sum = sum_.begin();
    for (int j = box_.top; j < box_.bottom; ++j) {
        for (int i = box_.left; i < box_.right; ++i) {
            const Bgr colour = frame.at(i, j);
            *sum++ += glm::vec3(colour[0], colour[1], colour[2]);
        }
    }
}

fields::Planes StillPicture::mean() const {
    fields::Planes mean{Plane<std::uint8_t>(box_.size()), Plane<Bgr>(box_.size())};
    for (std::size_t k = 0; k < sum_.size(); ++k) {
        const glm::vec3 value = glm::round(sum_[k] / static_cast<float>(std::max(1, count_)));
        const Bgr colour{static_cast<std::uint8_t>(value.x), static_cast<std::uint8_t>(value.y),
                         static_cast<std::uint8_t>(value.z)};
        mean.colour.pixels()[k] = colour;
        mean.grey.pixels()[k] = static_cast<std::uint8_t>(fields::brightness_of(colour));
    }
    return mean;
}

std::optional<SceneComparison> compare_with_scene(const StillPicture& still, const Patch& settled,
                                                  const fields::Planes& scene) {
    if (still.empty() || scene.empty()) return std::nullopt;
    const PixelBox& box = still.box();
    fields::Planes mean = still.mean();
    if (scene.colour.empty()) mean.colour = {};
    const fields::Planes empty = part_of_scene(scene, box);
    match_light(mean, empty, settled, box);
    const Plane<std::uint8_t> differences = fields::largest_difference(mean, empty);
    cv::Mat difference;
    cv::blur(cv_view(differences), difference, {3, 3});
    std::optional<SceneComparison> best;
    for (const int level : thresholds.claim.levels) {
        std::optional<Patch> region = region_at(difference, level, settled, box);
        if (!region || region->area < thresholds.most * settled.area) continue;
        Patch local = *region;
        local.box = local.box.translated(-box.left, -box.top);
        const double edges = edge_strength(local, {mean.grey, mean.grey, mean.colour});
        const double scene_edges = edge_strength(local, {empty.grey, empty.grey, empty.colour});
        if (best && std::abs(edges - scene_edges) <= std::abs(best->edges - best->scene_edges)) continue;
        double sum = 0;
        for_each_pixel(local, [&](int i, int j, std::uint8_t) { sum += difference.at<std::uint8_t>(j, i); });
        best = SceneComparison{std::move(*region), sum / std::max(1, local.area), edges, scene_edges, 0};
    }
    if (best) best->thickness = thickness_of(best->region);
    return best;
}

double confidence_of(const Evidence& evidence) {
    const double stronger = std::max(evidence.edges, evidence.scene_edges);
    const double weaker = std::min(evidence.edges, evidence.scene_edges);
    return std::min({
        at_least(evidence.difference, thresholds.claim.difference),
        at_least(stronger - weaker, thresholds.claim.outline),
        at_least(stronger / std::max(1.0, weaker), thresholds.claim.ratio),
        at_least(evidence.thickness, thresholds.claim.thickness),
        at_least(evidence.alone, thresholds.bearer),
        at_most(evidence.moved, thresholds.claim.moved),
        at_least(evidence.novelty, thresholds.claim.novelty),
        at_most(evidence.flicker, thresholds.pixel.flicker),
        at_most(evidence.changed, thresholds.claim.changed),
        evidence.carried ? 1.0 : 0.0,
    });
}

}  // namespace vvr::tracking
