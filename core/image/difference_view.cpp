#include "core/image/difference_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace vvr::image {

namespace {

constexpr std::array<Rgba, 4> scale{Rgba{1, 0.86F, 0.1F, 1}, Rgba{0.95F, 0.3F, 0.05F, 1}, Rgba{0.65F, 0, 0.15F, 1},
                                    Rgba{0, 0, 0, 1}};

Rgba colour_of(float strength) {
    const float place = std::clamp(strength, 0.0F, 1.0F) * (scale.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), scale.size() - 2);
    const float share = place - static_cast<float>(below);
    return glm::mix(scale[below], scale[below + 1], share);
}

float grey_of(std::span<const float> values) {
    if (values.size() < 3) return values.empty() ? 0 : values[0];
    return 0.30F * values[0] + 0.59F * values[1] + 0.11F * values[2];
}

}  // namespace

Picture difference_picture(const Samples& a, const Comparison& comparison) {
    Picture picture{Plane<Rgba>(a.size)};
    for (int j = 0; j < a.size.height; ++j) {
        for (int i = 0; i < a.size.width; ++i) {
            const float difference = comparison.pixels.at(i, j);
            const float grey = 0.7F + 0.3F * std::clamp(grey_of(a.at(i, j)), 0.0F, 1.0F);
            picture.pixels.at(i, j) = difference > 0 ? colour_of(std::sqrt(difference)) : Rgba{grey, grey, grey, 1};
        }
    }
    return picture;
}

std::string difference_letters(const Plane<float>& pixels, double level, int columns) {
    constexpr std::string_view letters = ".:-=+*#%@";
    const int width = std::clamp(columns, 1, std::max(1, pixels.width()));
    // A letter is about twice as high as it is wide.
    const double wanted = 0.5 * width * pixels.height() / std::max(1, pixels.width());
    const int height = std::clamp(static_cast<int>(std::lround(wanted)), 1, std::max(1, pixels.height()));
    const std::string edge = fmt::format("+{:-<{}}+\n", "", width);
    std::string text = edge;
    for (int row = 0; row < height; ++row) {
        text += '|';
        for (int column = 0; column < width; ++column) {
            float most = 0;
            for (int j = row * pixels.height() / height; j < (row + 1) * pixels.height() / height; ++j) {
                for (int i = column * pixels.width() / width; i < (column + 1) * pixels.width() / width; ++i) {
                    most = std::max(most, pixels.at(i, j));
                }
            }
            const auto step = static_cast<std::size_t>(std::sqrt(std::clamp(most, 0.0F, 1.0F)) * letters.size());
            text += most > level ? letters[std::min(step, letters.size() - 1)] : ' ';
        }
        text += "|\n";
    }
    return text + edge;
}

}  // namespace vvr::image
