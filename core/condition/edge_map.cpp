#include "core/condition/edge_map.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"
#include "core/condition/thresholds.h"

namespace vvr::condition {

namespace {

constexpr int side = 8;  // gradients along a block

Plane<float> gradient(const cv::Mat& picture, int across, int down) {
    constexpr double levels_per_pixel = 1.0 / 8;  // of Sobel's sum of weights
    Plane<float> result({picture.cols, picture.rows});
    cv::Mat out = cv_view(result);
    cv::Sobel(picture, out, CV_32F, across, down, 3, levels_per_pixel);
    return result;
}

/// Sums over a block of two maps.
struct Products {
    double picture = 0;
    double view = 0;
    double both = 0;

    void add(const Plane<float>& a, const Plane<float>& b, const PixelBox& block, int x, int y) {
        for (int j = block.top; j < block.bottom; ++j) {
            const auto of_view = b.row(j).subspan(static_cast<std::size_t>(block.left), side);
            const auto of_picture = a.row(j + y).subspan(static_cast<std::size_t>(block.left + x), side);
            for (std::size_t i = 0; i < side; ++i) {
                picture += static_cast<double>(of_picture[i]) * of_picture[i];
                view += static_cast<double>(of_view[i]) * of_view[i];
                both += static_cast<double>(of_picture[i]) * of_view[i];
            }
        }
    }
};

}  // namespace

EdgeMap edge_map(const Plane<std::uint8_t>& grey) {
    const Size small = fit_into(grey.size(), thresholds.side);
    cv::Mat picture;
    cv::resize(cv_view(grey), picture, {small.width, small.height}, 0, 0, cv::INTER_AREA);
    return {gradient(picture, 1, 0), gradient(picture, 0, 1)};
}

Agreement agreement(const EdgeMap& picture, const EdgeMap& view, int x, int y) {
    Agreement found;
    int all_blocks = 0;
    if (picture.across.size() != view.across.size()) return found;
    int similar = 0;
    int same = 0;
    double here = 0;
    double there = 0;
    const PixelBox all{0, 0, view.across.width(), view.across.height()};
    for (int top = 0; top + side <= all.bottom; top += side) {
        for (int left = 0; left + side <= all.right; left += side) {
            const PixelBox block{left, top, left + side, top + side};
            if (!all.contains(block.translated(x, y))) continue;
            ++all_blocks;
            Products sums;
            sums.add(picture.across, view.across, block, x, y);
            sums.add(picture.down, view.down, block, x, y);
            if (sums.view < thresholds.edge * thresholds.edge * side * side) continue;
            const double correlation = sums.picture > 0 ? sums.both / std::sqrt(sums.picture * sums.view) : 0;
            ++found.blocks;
            similar += correlation >= thresholds.similar ? 1 : 0;
            same += correlation >= thresholds.same ? 1 : 0;
            here += std::sqrt(sums.picture);
            there += std::sqrt(sums.view);
        }
    }
    // Where most of a view is plain, whoever passes hides all of its edges.
    if (found.blocks < thresholds.edged * all_blocks) return {};
    if (found.blocks == 0) return found;
    found.share = 1.0 * similar / found.blocks;
    found.exact = 1.0 * same / found.blocks;
    found.contrast = here / there;
    return found;
}

bool shows(const Agreement& view) {
    return view.blocks < thresholds.fewest_blocks || view.share >= thresholds.seen ||
           view.exact >= thresholds.seen_exactly;
}

bool shows_shifted(const EdgeMap& picture, const EdgeMap& view) {
    constexpr int most = 2;
    for (int y = -most; y <= most; ++y) {
        for (int x = -most; x <= most; ++x) {
            if (shows(agreement(picture, view, x, y))) return true;
        }
    }
    return false;
}

}  // namespace vvr::condition
