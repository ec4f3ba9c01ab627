#include "core/image/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"

namespace vvr {

namespace {

float pixel_difference(const Rgba& a, const Rgba& b) {
    float largest = 0;
    for (std::size_t c = 0; c < a.size(); ++c) {
        const float difference = std::abs(a[c] - b[c]);
        if (std::isnan(difference)) return std::numeric_limits<float>::infinity();
        largest = std::max(largest, difference);
    }
    return largest;
}

}  // namespace

Difference compare(const Picture& a, const Picture& b) {
    const Size size = a.pixels.size();
    if (size != b.pixels.size()) {
        throw Error(ErrorKind::differs, fmt::format("the pictures differ in size: {}x{} and {}x{}", size.width,
                                                    size.height, b.pixels.width(), b.pixels.height()));
    }
    Difference difference{.pixels = Plane<float>(size)};
    double sum = 0;
    for (int j = 0; j < size.height; ++j) {
        for (int i = 0; i < size.width; ++i) {
            const float here = pixel_difference(a.pixels.at(i, j), b.pixels.at(i, j));
            difference.pixels.at(i, j) = here;
            sum += here;
            if (here > difference.max) {
                difference.max = here;
                difference.worst_column = i;
                difference.worst_row = j;
            }
        }
    }
    if (!difference.pixels.empty()) difference.mean = sum / static_cast<double>(difference.pixels.pixels().size());
    return difference;
}

float percentile(const Difference& difference, double part) {
    std::vector<float> values(difference.pixels.pixels().begin(), difference.pixels.pixels().end());
    if (values.empty()) return 0;
    const auto last = static_cast<double>(values.size() - 1);
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(std::ceil(std::clamp(part, 0.0, 1.0) * last));
    std::ranges::nth_element(values, place);
    return *place;
}

}  // namespace vvr
