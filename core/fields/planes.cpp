#include "core/fields/planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <numeric>

#include <fmt/format.h>
#include <opencv2/core.hpp>

#include "core/base/cv_view.h"
#include "core/base/error.h"
#include "core/base/setting.h"
#include "core/fields/thresholds.h"
#include "core/kernels/rows.h"

namespace vvr::fields {
namespace {

template <class T>
Plane<T> smooth_plane(const Plane<T>& plane, double sigma) {
    if (plane.empty() || sigma <= 0) return plane;
    auto result = Plane<T>::for_overwrite(plane.size());
    const std::size_t count = plane.pixels().size_bytes();
    kernels::blur_bytes(plane.size(), sizeof(T), sigma,
                        {reinterpret_cast<const std::uint8_t*>(plane.pixels().data()), count},
                        {reinterpret_cast<std::uint8_t*>(result.pixels().data()), count});
    return result;
}

/// How often a channel is by -255 to 255 levels brighter than green.
using Tints = std::array<int, 511>;

/// Whether the median is a colour, or more than one in twenty differ from it by `least_tint` or more.
bool are_colours(const Tints& tints) {
    const int count = std::accumulate(tints.begin(), tints.end(), 0);
    int below = 0;
    auto median = tints.begin();
    while (2 * (below + *median) < count) below += *median++;
    if (count > 0 && std::abs(median - tints.begin() - 255) > thresholds.colour.most_tint_of_grey) return true;
    const auto most = static_cast<std::ptrdiff_t>(thresholds.colour.least_tint - 1);
    const auto first = median - std::min(most, median - tints.begin());
    const auto last = median + std::min(most + 1, tints.end() - median);
    return 20 * (count - std::accumulate(first, last, 0)) > count;
}

bool has_colours_in(const Plane<Bgr>& picture, const PixelBox& part) {
    Tints blue{};
    Tints red{};
    for (int j = part.top; j < part.bottom; j += thresholds.sampling) {
        for (int i = part.left; i < part.right; i += thresholds.sampling) {
            const auto [b, g, r] = picture.at(i, j);
            ++blue[static_cast<std::size_t>(255 + b - g)];
            ++red[static_cast<std::size_t>(255 + r - g)];
        }
    }
    return are_colours(blue) || are_colours(red);
}

}  // namespace

bool has_colours(const Plane<Bgr>& picture) {
    return has_colours_in(picture, {0, 0, picture.width(), picture.height()});
}

bool has_colours_everywhere(const Plane<Bgr>& picture) {
    constexpr int parts = 3;  // along each side
    int coloured = 0;
    for (int y = 0; y < parts; ++y) {
        for (int x = 0; x < parts; ++x) {
            const PixelBox part{x * picture.width() / parts, y * picture.height() / parts,
                                (x + 1) * picture.width() / parts, (y + 1) * picture.height() / parts};
            coloured += has_colours_in(picture, part) ? 1 : 0;
        }
    }
    return 3 * coloured >= 2 * parts * parts;
}

Planes smoothed(const Plane<std::uint8_t>& grey, const Plane<Bgr>& colour, double sigma) {
    return {smooth_plane(grey, sigma), smooth_plane(colour, sigma)};
}

Plane<std::uint8_t> largest_difference(const Planes& a, const Planes& b) {
    auto result = Plane<std::uint8_t>::for_overwrite(a.grey.size());
    if (a.colour.empty() || b.colour.empty()) {
        cv::absdiff(cv_view(a.grey), cv_view(b.grey), cv_view(result));
        return result;
    }
    kernels::largest_difference(a.colour.pixels(), b.colour.pixels(), result.pixels());
    return result;
}

namespace {

Plane<std::uint8_t> luminance_difference(const Planes& a, const Planes& b) {
    auto result = Plane<std::uint8_t>::for_overwrite(a.grey.size());
    cv::absdiff(cv_view(a.grey), cv_view(b.grey), cv_view(result));
    return result;
}

/// The distance between two points in the plane of hue (angle) and saturation (radius). Brightness doesn't count.
std::uint8_t distance_in_hue(const Bgr& a, const Bgr& b) {
    const int blue = a[0] - b[0];
    const int green = a[1] - b[1];
    const int red = a[2] - b[2];
    const float along_red = static_cast<float>(2 * red - green - blue) / 2;
    const float across = std::numbers::sqrt3_v<float> / 2 * static_cast<float>(green - blue);
    return static_cast<std::uint8_t>(std::min(std::hypot(along_red, across), 255.F));
}

Plane<std::uint8_t> hue_difference(const Planes& a, const Planes& b) {
    auto result = Plane<std::uint8_t>::for_overwrite(a.grey.size());
    std::ranges::transform(a.colour.pixels(), b.colour.pixels(), result.pixels().begin(), distance_in_hue);
    return result;
}

constexpr std::array norm_rows{
    NormRow{"channel", "the channel that differs most", false, largest_difference},
    NormRow{"luminance", "the brightness alone", false, luminance_difference},
    NormRow{"hue", "hue and saturation; ignores brightness and soft shadows", true, hue_difference},
};

}  // namespace

std::span<const NormRow> norms() {
    return norm_rows;
}

const NormRow& norm_for(const NormRow& norm, const Planes& picture) {
    if (!norm.needs_colour || !picture.colour.empty()) return norm;
    throw Error(ErrorCode::input_unsuitable,
                fmt::format("norm: '{}' needs colour, and the video is grey; choose 'luminance'", norm.name), {"norm"});
}

const NormRow& row_of(Name<NormRow> name) {
    return choose("norm", name.text, norms());
}

}  // namespace vvr::fields
