#include "core/tracking/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <span>

#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"
#include "core/media/scaler.h"
#include "core/tracking/event_options.h"

namespace vvr::tracking {

namespace {

constexpr std::size_t run = 64;

/// The difference of each of 64 pixels. Bytes alone and a fixed count, so that the compiler takes many at once.
std::array<std::uint8_t, run> differences_of(std::span<const std::uint8_t, run> a,
                                             std::span<const std::uint8_t, run> b) {
    std::array<std::uint8_t, run> differences;
    for (std::size_t k = 0; k < run; ++k) {
        const std::uint8_t larger = std::max(a[k], b[k]);
        const std::uint8_t smaller = std::min(a[k], b[k]);
        differences[k] = static_cast<std::uint8_t>(larger - smaller);
    }
    return differences;
}

/// Calls `use` with the index of each pixel that changed. Few do: runs in which none does are skipped.
template <class Use>
void for_each_change(std::span<const std::uint8_t> values, std::span<const std::uint8_t> before, const Use& use) {
    std::size_t begin = 0;
    for (; begin + run <= values.size(); begin += run) {
        const auto differences = differences_of(values.subspan(begin).first<run>(), before.subspan(begin).first<run>());
        std::uint8_t most = 0;
        for (const std::uint8_t difference : differences) most = std::max(most, difference);
        if (most < thresholds.overlay.level) continue;
        for (std::size_t k = 0; k < run; ++k) {
            if (differences[k] >= thresholds.overlay.level) use(begin + k);
        }
    }
    for (std::size_t k = begin; k < values.size(); ++k) {
        if (std::abs(int{values[k]} - int{before[k]}) >= thresholds.overlay.level) use(k);
    }
}

}  // namespace

void ClockFinder::add(const Plane<std::uint8_t>& grey, const Moment& now) {
    if (grey.empty()) return;
    const bool first = before_.empty();
    // A longer gap doesn't tell at which phase a pixel changed.
    const bool follows = !first && now.seconds > last_ && now.seconds - last_ <= thresholds.overlay.most_between;
    if (first || now.seconds - begin_ >= thresholds.memory) {
        if (!first) look();
        changes_ = Plane<Changes>(grey.size());
        begin_ = now.seconds;
        next_look_ = begin_ + thresholds.overlay.every;
    }
    if (follows) {
        const auto second = static_cast<std::int32_t>(std::floor(now.seconds - begin_));
        const std::complex<float> phase(std::polar(1.0, 2 * std::numbers::pi * now.seconds));
        for_each_change(grey.pixels(), before_.pixels(), [&](std::size_t k) {
            Changes& changes = changes_.pixels()[k];
            changes.phases += phase;
            ++changes.count;
            if (changes.last != second) ++changes.seconds;
            changes.last = second;
        });
    }
    last_ = now.seconds;
    if (first)
        before_ = grey;
    else
        std::ranges::copy(grey.pixels(), before_.pixels().begin());
    if (now.seconds < next_look_) return;
    next_look_ = now.seconds + thresholds.overlay.every;
    look();
}

/// Looks for pixels that changed in phase: first those of the seconds, then what changes with them in the same line.
void ClockFinder::look() {
    const double seconds = last_ - begin_;
    const Size size = changes_.size();
    Plane<std::uint8_t> ticks(size);
    for (std::size_t k = 0; k < ticks.pixels().size(); ++k) {
        const Changes& changes = changes_.pixels()[k];
        const double length = std::abs(changes.phases) / std::max<double>(1, changes.count);
        const bool in_phase =
            length >= thresholds.overlay.in_phase && changes.count * length * length >= thresholds.overlay.rayleigh;
        const bool often = changes.seconds >= thresholds.overlay.every && 5 * changes.seconds >= seconds &&
                           changes.count <= thresholds.overlay.most_per_second * changes.seconds;
        ticks.pixels()[k] = often && in_phase ? 255 : 0;
    }
    cv::Mat near;
    cv::dilate(cv_view(ticks), near, cv::Mat::ones(3, 2 * thresholds.overlay.stroke + 1, CV_8U));
    cv::Mat labels;
    cv::Mat boxes;
    cv::Mat centres;
    const int count = cv::connectedComponentsWithStats(near, labels, boxes, centres, 8, CV_32S);
    for (int n = 1; n < count; ++n) {
        const cv::Rect around(boxes.at<int>(n, cv::CC_STAT_LEFT), boxes.at<int>(n, cv::CC_STAT_TOP),
                              boxes.at<int>(n, cv::CC_STAT_WIDTH), boxes.at<int>(n, cv::CC_STAT_HEIGHT));
        const cv::Mat own = (labels(around) == n) & cv_view(ticks)(around);
        const int pixels = cv::countNonZero(own);
        const cv::Rect digit = cv::boundingRect(own) + around.tl();
        if (pixels < thresholds.overlay.stroke || digit.height > thresholds.overlay.height * size.height) continue;
        std::complex<float> phase;
        for (int j = digit.y; j < digit.y + digit.height; ++j) {
            for (int i = digit.x; i < digit.x + digit.width; ++i) {
                if (ticks.at(i, j) != 0) phase += changes_.at(i, j).phases;
            }
        }
        phase /= std::abs(phase);
        // The strokes that change less often, the tens of seconds and the minutes change at the same phase.
        PixelBox line{digit.x, digit.y, digit.x + digit.width, digit.y + digit.height};
        const auto changes_with_it = [&](const PixelBox& strip) {
            int in_phase = 0;
            int others = 0;
            for (int j = strip.top; j < strip.bottom; ++j) {
                for (int i = strip.left; i < strip.right; ++i) {
                    const Changes& changes = changes_.at(i, j);
                    if (changes.count == 0) continue;
                    const float along = (changes.phases * std::conj(phase)).real();
                    (along >= static_cast<float>(thresholds.overlay.in_phase * changes.count) ? in_phase : others) += 1;
                }
            }
            return in_phase > 2 * others;
        };
        for (int step = 0; step < line.width(); ++step) {
            if (line.top > 0 && changes_with_it({line.left, line.top - 1, line.right, line.top})) --line.top;
            if (line.bottom < size.height && changes_with_it({line.left, line.bottom, line.right, line.bottom + 1}))
                ++line.bottom;
        }
        const int reach = 2 * line.height();
        for (int i = line.left; i >= 0 && i >= line.left - reach; --i) {
            if (changes_with_it({i, line.top, i + 1, line.bottom})) line.left = i;
        }
        for (int i = line.right - 1; i < size.width && i < line.right + reach; ++i) {
            if (changes_with_it({i, line.top, i + 1, line.bottom})) line.right = i + 1;
        }
        keep(intersection(line.inflated(thresholds.overlay.stroke, thresholds.overlay.stroke),
                          {0, 0, size.width, size.height}));
    }
}

/// Adds a box, or widens one that it meets.
void ClockFinder::keep(const PixelBox& box) {
    const auto known = std::ranges::find_if(found_, [&](const PixelBox& other) { return other.intersects(box); });
    if (known == found_.end()) {
        found_.push_back(box);
    } else {
        *known = bounding_box(*known, box);
    }
}

std::vector<PixelBox> find_clocks(media::FrameSource& clip) {
    const media::VideoInfo& info = clip.info();
    if (info.duration <= 0 && info.frames <= 0) return {};
    ClockFinder finder;
    media::Scaler scale(clip);
    clip.rewind();
    while (const std::unique_ptr<media::DecodedFrame> decoded = clip.next()) {
        if (decoded->pts > thresholds.memory) break;
        finder.add(scale(*decoded).grey, {decoded->index, decoded->pts});
    }
    finder.finish();
    clip.rewind();
    return finder.found();
}

}  // namespace vvr::tracking
