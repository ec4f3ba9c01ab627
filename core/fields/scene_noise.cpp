#include "core/fields/scene_noise.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <oneapi/tbb/parallel_for.h>
#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"
#include "core/fields/median_scene.h"
#include "core/fields/thresholds.h"

namespace vvr::fields {

Plane<std::uint8_t> noise_of(std::span<const media::Frame> frames, const Planes& scene, double smooth, bool shakes) {
    if (frames.size() < thresholds.scene.fewest) return {};
    const std::size_t step = std::max<std::size_t>(1, frames.size() / thresholds.noise.frames);
    std::vector<Plane<std::uint8_t>> differences((frames.size() + step - 1) / step);
    oneapi::tbb::parallel_for(std::size_t{0}, differences.size(), [&](std::size_t k) {
        const media::Frame& frame = frames[k * step];
        differences[k] = largest_difference(smoothed(frame.grey, frame.colour, smooth), scene);
    });
    const auto rank_of = [&](double part) {
        return differences.size() - static_cast<std::size_t>(part * static_cast<double>(differences.size() - 1));
    };
    Plane<std::uint8_t> noise(scene.grey.size());
    oneapi::tbb::parallel_for(0, noise.height(), [&](int j) {
        std::vector<const std::uint8_t*> rows;
        for (const Plane<std::uint8_t>& plane : differences) rows.push_back(plane.row(j).data());
        const std::span<std::uint8_t> row = noise.row(j);
        std::vector<std::uint8_t> stable(row.size());
        rank_rows(rows, rank_of(shakes ? thresholds.noise.share_shaking : thresholds.noise.share), row);
        rank_rows(rows, rank_of(thresholds.noise.stable), stable);
        for (std::size_t i = 0; i < row.size(); ++i) {
            row[i] = static_cast<std::uint8_t>(
                std::min<int>(row[i], thresholds.noise.most_ratio * stable[i] + thresholds.noise.most_excess));
        }
    });
    // Leaves that sway here also sway in the next pixel.
    cv::Mat out = cv_view(noise);
    out.convertTo(out, CV_8U, shakes ? thresholds.noise.to_median_shaking : thresholds.noise.to_median);
    cv::blur(out, out, {3, 3});
    cv::dilate(out, out, cv::Mat::ones(3, 3, CV_8U));
    return noise;
}

}  // namespace vvr::fields
