#include "core/fields/noise.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <oneapi/tbb/parallel_for.h>
#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"

namespace vvr::fields {
namespace {

constexpr std::size_t fewest_frames = 8;

// Every third frame is enough.
constexpr std::size_t frame_step = 3;

// The share of the frames that counts, and the factor that makes the largest of their differences a median: 0.67 σ /
// 0.45 σ for Gaussian noise.
constexpr double share = 0.35;
constexpr double to_median = 1.5;

// The share of the frames that surely show the scene even where an object lies for most of the clip. Noise is limited
// to this multiple of theirs, plus some levels: anything above is the object.
constexpr double sure_share = 0.15;
constexpr int most_times = 4;
constexpr int most_more = 2;

}  // namespace

Plane<std::uint8_t> noise_of(std::span<const video::Frame> frames, const Planes& scene, double smooth) {
    std::vector<Plane<std::uint8_t>> differences((frames.size() + frame_step - 1) / frame_step);
    if (differences.size() < fewest_frames) return {};
    oneapi::tbb::parallel_for(std::size_t{0}, differences.size(), [&](std::size_t k) {
        const video::Frame& frame = frames[k * frame_step];
        differences[k] = largest_difference(smoothed(frame.grey, frame.colour, smooth), scene);
    });
    const auto place_of = [&](double part) {
        return differences.size() - static_cast<std::size_t>(part * static_cast<double>(differences.size() - 1));
    };
    Plane<std::uint8_t> noise(scene.grey.size());
    oneapi::tbb::parallel_for(0, noise.height(), [&](int j) {
        std::vector<const std::uint8_t*> rows;
        for (const Plane<std::uint8_t>& plane : differences) rows.push_back(plane.row(j).data());
        const std::span<std::uint8_t> row = noise.row(j);
        std::vector<std::uint8_t> sure(row.size());
        rank_rows(rows, place_of(share), row);
        rank_rows(rows, place_of(sure_share), sure);
        for (std::size_t i = 0; i < row.size(); ++i) {
            row[i] = static_cast<std::uint8_t>(std::min<int>(row[i], most_times * sure[i] + most_more));
        }
    });
    // What sways here also sways next to it.
    cv::Mat out = cv_view(noise);
    out.convertTo(out, CV_8U, to_median);
    cv::blur(out, out, {3, 3});
    cv::dilate(out, out, cv::Mat::ones(3, 3, CV_8U));
    return noise;
}

}  // namespace vvr::fields
