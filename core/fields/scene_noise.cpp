#include "core/fields/scene_noise.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <oneapi/tbb/parallel_for.h>
#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"
#include "core/fields/median_scene.h"

namespace vvr::fields {

namespace {

constexpr std::size_t fewest_frames = 8;

// About this many, spread over the clip, are enough.
constexpr std::size_t enough_frames = 10;

/// The share of the frames that counts, and the factor that makes the largest of their differences a median: for
/// Gaussian noise, 0.67 σ / 0.32 σ or 0.67 σ / 0.43 σ.
struct Sample {
    double share;
    double to_median;
};

// Where somebody stands at a counter, the scene may be empty in no more than a quarter of the frames. If the camera
// shakes, edges tremble, but not in each frame: so few frames don't tell.
constexpr Sample still_camera{0.25, 2.1};
constexpr Sample shaking_camera{1.0 / 3, 1.55};

// The share of the frames that show the empty scene even where an object lies for most of the clip. The noise is at
// most this multiple of the noise in these frames, plus some grey levels: larger deviations are the object.
constexpr double stable_share = 0.15;
constexpr int max_ratio = 4;
constexpr int max_excess = 2;

}  // namespace

Plane<std::uint8_t> noise_of(std::span<const media::Frame> frames, const Planes& scene, double smooth, bool shakes) {
    const Sample sample = shakes ? shaking_camera : still_camera;
    if (frames.size() < fewest_frames) return {};
    const std::size_t step = std::max<std::size_t>(1, frames.size() / enough_frames);
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
        rank_rows(rows, rank_of(sample.share), row);
        rank_rows(rows, rank_of(stable_share), stable);
        for (std::size_t i = 0; i < row.size(); ++i) {
            row[i] = static_cast<std::uint8_t>(std::min<int>(row[i], max_ratio * stable[i] + max_excess));
        }
    });
    // Leaves that sway here also sway in the next pixel.
    cv::Mat out = cv_view(noise);
    out.convertTo(out, CV_8U, sample.to_median);
    cv::blur(out, out, {3, 3});
    cv::dilate(out, out, cv::Mat::ones(3, 3, CV_8U));
    return noise;
}

}  // namespace vvr::fields
