#include "core/fields/views.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"
#include "core/condition/condition_finder.h"
#include "core/condition/edge_map.h"
#include "core/condition/thresholds.h"
#include "core/fields/illumination.h"
#include "core/fields/planes.h"
#include "core/fields/thresholds.h"

namespace vvr::fields {

namespace {

/// The view of each frame: a number, from 0. Light that changes slowly changes most edges in the end, so a frame
/// belongs to a view if it shows what one other frame of it shows.
std::vector<int> views_of(std::span<const condition::EdgeMap> maps, std::span<const int> modes,
                          bool (*shows_same)(const condition::EdgeMap&, const condition::EdgeMap&)) {
    std::vector<int> views;
    int count = 0;
    for (std::size_t k = 0; k < maps.size(); ++k) {
        std::size_t like = 0;
        while (like < k && !(modes[like] == modes[k] && shows_same(maps[k], maps[like]))) ++like;
        views.push_back(like < k ? views[like] : count++);
    }
    return views;
}

bool shows_same_view(const condition::EdgeMap& a, const condition::EdgeMap& b) {
    return condition::shows(condition::agreement(a, b));
}

/// Smaller: in the dark, single pixels have the colours of noise.
Plane<Bgr> without_noise(const Plane<Bgr>& picture) {
    constexpr int side = 48;  // pixels
    Plane<Bgr> small(fit_into(picture.size(), side));
    cv::Mat out = cv_view(small);
    cv::resize(cv_view(picture), out, out.size(), 0, 0, cv::INTER_AREA);
    return small;
}

}  // namespace

bool shows_infrared(const media::Frame& frame) {
    if (frame.colour.empty() || has_colours(without_noise(frame.colour))) return false;
    const Quantiles levels = quantiles_of(frame.grey);
    return levels.back() - levels.front() >= thresholds.scene.least_contrast;
}

std::vector<std::vector<media::Frame>> by_view(std::vector<media::Frame> frames) {
    const bool has_colour =
        std::ranges::any_of(frames, [](const media::Frame& frame) { return has_colours_everywhere(frame.colour); });
    std::vector<std::size_t> shown;
    std::vector<condition::EdgeMap> maps;
    std::vector<int> modes;
    for (std::size_t k = 0; k < frames.size(); ++k) {
        condition::FrameSigns signs = condition::signs_of(frames[k].grey);
        if (condition::is_blank(signs)) continue;
        shown.push_back(k);
        maps.push_back(std::move(signs.edges));
        modes.push_back(has_colour && shows_infrared(frames[k]) ? 1 : 0);
    }
    std::vector<int> views = views_of(maps, modes, shows_same_view);
    std::size_t changes = 0;
    for (std::size_t k = 1; k < views.size(); ++k) changes += views[k] != views[k - 1] ? 1 : 0;
    // A camera that shakes shows another view again and again.
    if (6 * changes > views.size()) views = views_of(maps, modes, condition::shows_shifted);

    std::vector<std::vector<media::Frame>> groups;
    for (std::size_t k = 0; k < views.size(); ++k) {
        groups.resize(std::max(groups.size(), static_cast<std::size_t>(views[k]) + 1));
        groups[static_cast<std::size_t>(views[k])].push_back(frames[shown[k]]);
    }
    std::erase_if(groups, [](const auto& group) { return group.size() < condition::thresholds.fewest_of_view; });
    if (groups.empty()) return {std::move(frames)};
    std::ranges::stable_sort(groups, std::greater{}, &std::vector<media::Frame>::size);
    return groups;
}

bool is_view_of(const Plane<std::uint8_t>& scene, std::span<const media::Frame> frames) {
    const condition::EdgeMap view = condition::edge_map(scene);
    const auto shown = std::ranges::count_if(
        frames, [&](const media::Frame& frame) { return shows_same_view(condition::edge_map(frame.grey), view); });
    return 2 * shown >= std::ssize(frames);
}

}  // namespace vvr::fields
