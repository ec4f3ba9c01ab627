#include "core/fields/stabilizer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <oneapi/tbb/parallel_for.h>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include "core/base/cv_view.h"
#include "core/base/setting.h"
#include "core/fields/options.h"
#include "core/fields/thresholds.h"

namespace vvr::fields {
namespace {

constexpr std::array stabilizer_rows{
    StabilizerRow{"auto", "align frames if the camera shakes", true},
    StabilizerRow{"off", "compare frames unaligned", false},
};

const cv::Size window{thresholds.shake.window, thresholds.shake.window};
const cv::TermCriteria accuracy{cv::TermCriteria::COUNT | cv::TermCriteria::EPS, thresholds.shake.steps,
                                thresholds.shake.precision};

/// The mean of the largest set of shifts that agree.
Shift consensus_shift(const std::vector<cv::Point2f>& shifts) {
    const auto agree = [](const cv::Point2f& a, const cv::Point2f& b) {
        return std::abs(a.x - b.x) < thresholds.shake.tolerance && std::abs(a.y - b.y) < thresholds.shake.tolerance;
    };
    std::ptrdiff_t most = 0;
    cv::Point2f best;
    for (const cv::Point2f& candidate : shifts) {
        const auto count = std::ranges::count_if(shifts, [&](const cv::Point2f& s) { return agree(s, candidate); });
        if (count > most) {
            most = count;
            best = candidate;
        }
    }
    const double needed = std::max<double>(thresholds.shake.fewest_agreeing,
                                           thresholds.shake.agreeing * static_cast<double>(shifts.size()));
    if (static_cast<double>(most) < needed) return {};
    Shift mean;
    for (const cv::Point2f& shift : shifts) {
        if (!agree(shift, best)) continue;
        mean.x += shift.x / static_cast<double>(most);
        mean.y += shift.y / static_cast<double>(most);
    }
    return mean;
}

double median_of(std::span<const Shift> shifts, double Shift::*part) {
    std::vector<double> values;
    for (const Shift& shift : shifts) values.push_back(shift.*part);
    const auto half = values.begin() + std::ssize(values) / 2;
    std::ranges::nth_element(values, half);
    return *half;
}

bool is_visible(const Shift& shift) {
    return std::hypot(shift.x, shift.y) >= thresholds.shake.visible;
}

template <class T>
void move_back(Plane<T>& plane, const Plane<T>& background, const Shift& shift) {
    if (plane.empty() || background.empty()) return;
    Plane<T> moved = background;
    cv::Mat out = cv_view(moved);
    const cv::Matx23d move(1, 0, shift.x, 0, 1, shift.y);
    cv::warpAffine(cv_view(plane), out, move, out.size(), cv::INTER_CUBIC | cv::WARP_INVERSE_MAP,
                   cv::BORDER_TRANSPARENT);
    plane = std::move(moved);
}

Planes planes_of(const media::Frame& frame) {
    return {frame.grey, frame.colour};
}

}  // namespace

std::span<const StabilizerRow> stabilizers() {
    return stabilizer_rows;
}

/// The corners of the reference that are tracked.
struct Stabilizer::Landmarks {
    std::vector<cv::Mat> pyramid;
    std::vector<cv::Point2f> points;

    explicit Landmarks(const Plane<std::uint8_t>& picture) {
        const cv::Mat grey = cv_view(picture);
        const double apart = std::max(picture.width(), picture.height()) / double{thresholds.shake.points_per_side};
        cv::goodFeaturesToTrack(grey, points, thresholds.shake.points, thresholds.shake.quality, apart);
        cv::buildOpticalFlowPyramid(grey, pyramid, window, thresholds.shake.top_level);
    }
};

Stabilizer::Stabilizer(const Planes& reference)
    : reference_(reference), landmarks_(std::make_unique<const Landmarks>(reference_.grey)) {}

Stabilizer::~Stabilizer() = default;

Shift Stabilizer::shift_of(const Plane<std::uint8_t>& grey) const {
    const std::vector<cv::Point2f>& points = landmarks_->points;
    if (points.empty()) return {};
    std::vector<cv::Point2f> found;
    std::vector<unsigned char> is_found;
    cv::calcOpticalFlowPyrLK(landmarks_->pyramid, cv_view(grey), points, found, is_found, cv::noArray(), window,
                             thresholds.shake.top_level, accuracy);
    std::vector<cv::Point2f> shifts;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (is_found[k] != 0) shifts.push_back(found[k] - points[k]);
    }
    return consensus_shift(shifts);
}

VisibleArea Stabilizer::align(media::Frame& frame, const Shift& shift) const {
    const int width = frame.grey.width();
    const int height = frame.grey.height();
    move_back(frame.grey, reference_.grey, shift);
    move_back(frame.colour, reference_.colour, shift);
    frame.full_size.left += shift.x;
    frame.full_size.top += shift.y;
    const auto cut = [](double edge, int most) { return std::clamp(static_cast<int>(std::ceil(edge)), 0, most); };
    return {.left = cut(-shift.x, width),
            .right = width - cut(shift.x, width),
            .top = cut(-shift.y, height),
            .bottom = height - cut(shift.y, height)};
}

void clear_outside_overlap(const VisibleArea& visible, Plane<std::uint8_t>& plane) {
    for (int j = 0; j < plane.height(); ++j) {
        const std::span<std::uint8_t> row = plane.row(j);
        const bool seen = j >= visible.top && j < visible.bottom;
        std::fill(row.begin(), row.begin() + (seen ? visible.left : plane.width()), std::uint8_t{0});
        std::fill(row.begin() + visible.right, row.end(), std::uint8_t{0});
    }
}

bool camera_shakes(std::span<const media::Frame> frames) {
    if (frames.size() < 2) return false;
    const Stabilizer stabilizer(planes_of(frames.front()));
    std::vector<char> moved(frames.size());
    oneapi::tbb::parallel_for(std::size_t{1}, frames.size(), [&](std::size_t k) {
        moved[k] = is_visible(stabilizer.shift_of(frames[k].grey)) ? 1 : 0;
    });
    // A single frame may be damaged.
    return std::ranges::count(moved, 1) >= 2;
}

void align(std::span<media::Frame> frames) {
    if (frames.empty()) return;
    const Stabilizer stabilizer(planes_of(frames.front()));
    std::vector<Shift> shifts(frames.size());
    const auto each = [&](const auto& work) { oneapi::tbb::parallel_for(std::size_t{0}, frames.size(), work); };
    each([&](std::size_t k) { shifts[k] = stabilizer.shift_of(frames[k].grey); });
    const Shift middle{median_of(shifts, &Shift::x), median_of(shifts, &Shift::y)};
    each([&](std::size_t k) { stabilizer.align(frames[k], {shifts[k].x - middle.x, shifts[k].y - middle.y}); });
}

const StabilizerRow& row_of(Name<StabilizerRow> name) {
    return choose("stabilize", name.text, stabilizers());
}

}  // namespace vvr::fields
