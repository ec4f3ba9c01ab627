#include "core/fields/running_reference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <span>

#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"
#include "core/fields/thresholds.h"

namespace vvr::fields {
namespace {

template <class T>
void follow(std::vector<float>& exact, std::span<const T> frame, std::span<const std::uint8_t> near_object,
            std::size_t channels, const IlluminationChange& light, float rate, std::uint8_t* out) {
    const auto gain = static_cast<float>(light.gain);
    const auto offset = static_cast<float>(light.offset);
    const std::uint8_t* const levels = reinterpret_cast<const std::uint8_t*>(frame.data());
    for (std::size_t i = 0; i < exact.size(); ++i) {
        exact[i] = std::clamp(gain * exact[i] + offset, 0.F, 255.F);
        if (near_object[i / channels] == 0) exact[i] += rate * (levels[i] - exact[i]);
        out[i] = static_cast<std::uint8_t>(std::lround(exact[i]));
    }
}

// Milliseconds.
constexpr int ghost_after = 1000 * thresholds.running.ghost;

/// The largest gradient at and next to each pixel.
cv::Mat gradient(const Plane<std::uint8_t>& grey) {
    cv::Mat steep;
    cv::morphologyEx(cv_view(grey), steep, cv::MORPH_GRADIENT, cv::Mat::ones(3, 3, CV_8U));
    return steep;
}

/// 255 where a blob of `steady` is a ghost, and some pixels around it; empty if there is none.
Plane<std::uint8_t> find_ghosts(const Plane<std::uint8_t>& steady, const Plane<std::uint8_t>& frame,
                                const Plane<std::uint8_t>& reference) {
    cv::Mat labels, boxes, centres;
    const int count = cv::connectedComponentsWithStats(cv_view(steady), labels, boxes, centres);
    if (count <= 1) return {};
    cv::Mat inner;
    cv::erode(cv_view(steady), inner, cv::Mat::ones(3, 3, CV_8U));
    const cv::Mat here = gradient(frame);
    const cv::Mat there = gradient(reference);
    struct Outline {
        double here = 0, there = 0, pixels = 0;
    };
    std::vector<Outline> outlines(static_cast<std::size_t>(count));
    for (int j = 0; j < labels.rows; ++j) {
        for (int i = 0; i < labels.cols; ++i) {
            const int label = labels.at<int>(j, i);
            if (label == 0 || inner.at<std::uint8_t>(j, i) != 0) continue;
            Outline& outline = outlines[static_cast<std::size_t>(label)];
            outline.here += here.at<std::uint8_t>(j, i);
            outline.there += there.at<std::uint8_t>(j, i);
            outline.pixels += 1;
        }
    }
    Plane<std::uint8_t> ghosts(steady.size());
    bool any = false;
    for (int j = 0; j < labels.rows; ++j) {
        for (int i = 0; i < labels.cols; ++i) {
            const Outline& outline = outlines[static_cast<std::size_t>(labels.at<int>(j, i))];
            if (outline.there < thresholds.running.edge_step * outline.pixels ||
                outline.there < thresholds.running.edge_ratio * outline.here)
                continue;
            if (labels.at<int>(j, i) == 0) continue;
            ghosts.at(i, j) = 255;
            any = true;
        }
    }
    if (!any) return {};
    cv::Mat out = cv_view(ghosts);
    cv::dilate(out, out, cv::Mat(), {-1, -1}, thresholds.running.edge);
    return ghosts;
}

}  // namespace

RunningReference::RunningReference(const Planes& start)
    : now_(start),
      last_level_(start.grey.size()),
      steady_for_(start.grey.size()),
      grey_(start.grey.pixels().begin(), start.grey.pixels().end()) {
    for (const Bgr& pixel : start.colour.pixels()) colour_.insert(colour_.end(), pixel.begin(), pixel.end());
}

void RunningReference::adapt(const Planes& frame, const Plane<std::uint8_t>& object, const IlluminationChange& light,
                             double seconds) {
    const double since = adapted_ ? seconds - *adapted_ : thresholds.running.first;
    adapted_ = seconds;
    absorb_ghosts(frame, object,
                  static_cast<int>(std::lround(1000 * std::clamp(since, 0.001, 2.0 * thresholds.running.ghost))));
    const auto rate = static_cast<float>(since / (since + thresholds.running.slowness));
    Plane<std::uint8_t> near_object(object.size());
    cv::Mat out = cv_view(near_object);
    cv::dilate(cv_view(object), out, cv::Mat(), {-1, -1}, thresholds.running.edge);
    follow<std::uint8_t>(grey_, frame.grey.pixels(), near_object.pixels(), 1, light, rate, now_.grey.pixels().data());
    if (colour_.empty() || frame.colour.empty()) return;
    follow<Bgr>(colour_, frame.colour.pixels(), near_object.pixels(), 3, light, rate,
                now_.colour.pixels().front().data());
}

/// \param passed milliseconds since the last frame
void RunningReference::absorb_ghosts(const Planes& frame, const Plane<std::uint8_t>& object, int passed) {
    for (std::size_t i = 0; i < object.pixels().size(); ++i) {
        std::uint16_t& steady = steady_for_.pixels()[i];
        std::uint8_t& last = last_level_.pixels()[i];
        const std::uint8_t level = frame.grey.pixels()[i];
        const bool is_same = steady > 0 && std::abs(level - last) <= thresholds.running.steady;
        if (!is_same) last = level;
        const int time = object.pixels()[i] == 0 ? 0 : is_same ? std::min(steady + passed, 2 * ghost_after) : passed;
        steady = static_cast<std::uint16_t>(time);
    }
    if ((since_check_ += passed) < 1000 * thresholds.running.check) return;
    since_check_ = 0;
    Plane<std::uint8_t> steady(object.size());
    std::ranges::transform(steady_for_.pixels(), steady.pixels().begin(),
                           [](int time) { return static_cast<std::uint8_t>(time >= ghost_after ? 255 : 0); });
    const Plane<std::uint8_t> ghosts = find_ghosts(steady, frame.grey, now_.grey);
    steady_pixels_ = cv::countNonZero(cv_view(steady));
    if (ghosts.empty()) return;
    steady_pixels_ = 0;  // the others are counted next time
    for (std::size_t i = 0; i < grey_.size(); ++i) {
        if (ghosts.pixels()[i] == 0) continue;
        grey_[i] = frame.grey.pixels()[i];
        now_.grey.pixels()[i] = frame.grey.pixels()[i];
        steady_for_.pixels()[i] = 0;
        if (colour_.empty() || frame.colour.empty()) continue;
        now_.colour.pixels()[i] = frame.colour.pixels()[i];
        for (std::size_t c = 0; c < 3; ++c) colour_[3 * i + c] = frame.colour.pixels()[i][c];
    }
}

}  // namespace vvr::fields
