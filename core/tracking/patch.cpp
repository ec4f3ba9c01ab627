#include "core/tracking/patch.h"

#include <algorithm>
#include <cstdlib>

#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"
#include "core/tracking/event_options.h"

namespace vvr::tracking {

namespace {

/// The bounding box of all non-zero pixels, extended by `reach`; empty for an empty field.
PixelBox box_of_objects(const Plane<std::uint8_t>& field, const glm::ivec2& reach) {
    const cv::Rect all = cv::boundingRect(cv_view(field));
    if (all.empty()) return {};
    const PixelBox wide = PixelBox{all.x, all.y, all.x + all.width, all.y + all.height}.inflated(reach.x, reach.y);
    return intersection(wide, {0, 0, field.width(), field.height()});
}

}  // namespace

bool touches_border(const PixelBox& box, Size field) {
    return box.left <= 1 || box.top <= 1 || box.right >= field.width - 1 || box.bottom >= field.height - 1;
}

bool is_mostly_inside(const PixelBox& box, const PixelBox& other) {
    const PixelBox both = intersection(box, other);
    return !both.empty() && both.width() * both.height() >= thresholds.most * box.width() * box.height();
}

Patch joined(const Patch& a, const Patch& b) {
    const PixelBox box = bounding_box(a.box, b.box);
    Patch whole{.box = box, .values = Plane<std::uint8_t>({box.width(), box.height()}), .area = 0, .centre = {}};
    for (int j = box.top; j < box.bottom; ++j) {
        for (int i = box.left; i < box.right; ++i) {
            const std::uint8_t value = std::max(a.at(i, j), b.at(i, j));
            if (value == 0) continue;
            whole.values.at(i - box.left, j - box.top) = value;
            whole.centre += glm::dvec2(i, j);
            ++whole.area;
        }
    }
    whole.centre /= std::max(1, whole.area);
    return whole;
}

Patch translated(Patch patch, const glm::ivec2& by) {
    patch.box = patch.box.translated(by.x, by.y);
    patch.centre += by;
    return patch;
}

Blobs find_blobs(const Plane<std::uint8_t>& field, const glm::ivec2& reach, int min_area) {
    Blobs blobs{Plane<int>(field.size()), {}};
    const PixelBox all = box_of_objects(field, reach);
    if (all.empty()) return blobs;
    cv::Mat wide;
    const cv::Rect part(all.left, all.top, all.width(), all.height());
    cv::dilate(cv_view(field)(part), wide, cv::Mat::ones(2 * reach.y + 1, 2 * reach.x + 1, CV_8U));
    cv::Mat labels = cv::Mat(field.height(), field.width(), CV_32S, blobs.labels.pixels().data())(part);
    const int count = cv::connectedComponents(wide, labels, 8, CV_32S);

    std::vector<Patch> found(static_cast<std::size_t>(count));
    for (int j = all.top; j < all.bottom; ++j) {
        for (int i = all.left; i < all.right; ++i) {
            if (field.at(i, j) == 0) continue;
            Patch& patch = found[static_cast<std::size_t>(blobs.labels.at(i, j))];
            patch.box = bounding_box(patch.box, {i, j, i + 1, j + 1});
            patch.centre += glm::dvec2(i, j);
            ++patch.area;
        }
    }
    std::vector<int> numbers(found.size());
    for (std::size_t k = 1; k < found.size(); ++k) {
        if (found[k].area < std::max(1, min_area)) continue;
        found[k].centre /= found[k].area;
        found[k].values = Plane<std::uint8_t>({found[k].box.width(), found[k].box.height()});
        blobs.patches.push_back(std::move(found[k]));
        numbers[k] = static_cast<int>(blobs.patches.size());
    }
    for (int j = all.top; j < all.bottom; ++j) {
        for (int i = all.left; i < all.right; ++i) {
            int& label = blobs.labels.at(i, j);
            label = numbers[static_cast<std::size_t>(label)];
        }
    }
    for (std::size_t k = 0; k < blobs.patches.size(); ++k) {
        Patch& patch = blobs.patches[k];
        for (int j = patch.box.top; j < patch.box.bottom; ++j) {
            for (int i = patch.box.left; i < patch.box.right; ++i) {
                if (blobs.labels.at(i, j) == static_cast<int>(k) + 1) {
                    patch.values.at(i - patch.box.left, j - patch.box.top) = field.at(i, j);
                }
            }
        }
    }
    return blobs;
}

double edge_strength(const Patch& patch, const FrameView& sight) {
    const Size picture = sight.field.size();
    double sum = 0;
    int count = 0;
    const auto at = [&](int i, int j) {
        return sight.brightness(std::clamp(i, 0, picture.width - 1), std::clamp(j, 0, picture.height - 1));
    };
    for_each_pixel(patch, [&](int i, int j, std::uint8_t) {
        const bool left = patch.at(i - 1, j) == 0;
        const bool right = patch.at(i + 1, j) == 0;
        const bool above = patch.at(i, j - 1) == 0;
        const bool below = patch.at(i, j + 1) == 0;
        if (!left && !right && !above && !below) return;
        const int dx = left || right ? std::abs(at(i + 1, j) - at(i - 1, j)) : 0;
        const int dy = above || below ? std::abs(at(i, j + 1) - at(i, j - 1)) : 0;
        sum += std::max(dx, dy);
        ++count;
    });
    return sum / std::max(1, count);
}

void add_runs(const Patch& patch, std::size_t track, FrameLabels& labels) {
    for (int j = 0; j < patch.box.height(); ++j) {
        int i = 0;
        while (i < patch.box.width()) {
            if (patch.values.at(i, j) == 0) {
                ++i;
                continue;
            }
            const int first = i;
            while (i < patch.box.width() && patch.values.at(i, j) != 0) ++i;
            labels.runs.push_back({patch.box.top + j, patch.box.left + first, patch.box.left + i, track});
        }
    }
}

std::vector<std::optional<std::size_t>> events_of_tracks(std::span<const Event> events) {
    std::vector<std::optional<std::size_t>> table;
    for (std::size_t place = 0; place < events.size(); ++place) {
        for (const std::size_t track : events[place].tracks) {
            if (track >= table.size()) table.resize(track + 1);
            table[track] = place;
        }
    }
    return table;
}

}  // namespace vvr::tracking
