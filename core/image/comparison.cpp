#include "core/image/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <string_view>

#include <fmt/format.h>

namespace vvr::image {

namespace {

constexpr std::size_t worst_pixels = 10;

std::string size_text(Size size) {
    return fmt::format("{}x{}", size.width, size.height);
}

/// The result for pictures whose values can't be compared; empty if they can.
std::optional<Comparison> refusal(const Samples& a, const Samples& b) {
    const auto refuse = [](Verdict verdict, std::string reason) {
        Comparison comparison;
        comparison.verdict = verdict;
        comparison.reason = std::move(reason);
        return comparison;
    };
    if (a.size != b.size) {
        return refuse(Verdict::size, fmt::format("the sizes differ, {} and {}", size_text(a.size), size_text(b.size)));
    }
    if (a.channels != b.channels) {
        return refuse(Verdict::channels, fmt::format("the channels differ, {} and {}", fmt::join(a.channels, ","),
                                                     fmt::join(b.channels, ",")));
    }
    const char* which = "first";
    for (const Samples* samples : {&a, &b}) {
        const auto bad = std::ranges::count_if(samples->values, [](float value) { return !std::isfinite(value); });
        if (bad > 0) {
            const auto at = std::ranges::find_if(samples->values, [](float value) { return !std::isfinite(value); });
            const auto pixel = (at - samples->values.begin()) / std::ssize(samples->channels);
            return refuse(
                Verdict::not_finite,
                fmt::format("{} {} of the {} picture {} not finite, first at {},{}", bad, bad == 1 ? "value" : "values",
                            which, bad == 1 ? "is" : "are", pixel % samples->size.width, pixel / samples->size.width));
        }
        which = "second";
    }
    return std::nullopt;
}

float largest(std::span<const float> a, std::span<const float> b) {
    float most = 0;
    for (std::size_t c = 0; c < a.size(); ++c) most = std::max(most, std::abs(a[c] - b[c]));
    return most;
}

/// The largest mean difference of a patch. Patches overlap by half, so a change on a border is not missed.
double worst_patch(const Plane<float>& pixels) {
    constexpr int stride = patch_size / 2;
    double worst = 0;
    for (int top = 0; top == 0 || top + stride < pixels.height(); top += stride) {
        for (int left = 0; left == 0 || left + stride < pixels.width(); left += stride) {
            double sum = 0;
            for (int j = top; j < std::min(top + patch_size, pixels.height()); ++j) {
                for (int i = left; i < std::min(left + patch_size, pixels.width()); ++i) sum += pixels.at(i, j);
            }
            worst = std::max(worst, sum / (patch_size * patch_size));
        }
    }
    return worst;
}

std::vector<PixelPair> worst_of(const Samples& a, const Samples& b, const Plane<float>& pixels) {
    std::vector<std::size_t> order(pixels.pixels().size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto count = std::min(worst_pixels, order.size());
    const auto values = pixels.pixels();
    std::ranges::partial_sort(order, order.begin() + static_cast<std::ptrdiff_t>(count),
                              [&](std::size_t one, std::size_t other) {
                                  return values[one] != values[other] ? values[one] > values[other] : one < other;
                              });
    std::vector<PixelPair> worst;
    for (const std::size_t place : std::span(order).first(count)) {
        if (values[place] <= 0) break;
        const auto width = static_cast<std::size_t>(pixels.width());
        const int i = static_cast<int>(place % width);
        const int j = static_cast<int>(place / width);
        const auto of_a = a.at(i, j);
        const auto of_b = b.at(i, j);
        worst.push_back({i, j, values[place], {of_a.begin(), of_a.end()}, {of_b.begin(), of_b.end()}});
    }
    return worst;
}

void judge(Comparison& comparison, const Tolerance& tolerance) {
    std::vector<std::string> reasons;
    if (comparison.percent > tolerance.percent) {
        reasons.push_back(fmt::format("{:.3g} % of the pixels differ by more than {:.3g}, the limit is {:.3g} %",
                                      comparison.percent, tolerance.level, tolerance.percent));
    }
    if (comparison.patch > tolerance.patch) {
        reasons.push_back(fmt::format("a patch of {0}x{0} pixels differs by {1:.3g} on average, the limit is {2:.3g}",
                                      patch_size, comparison.patch, tolerance.patch));
    }
    if (!reasons.empty()) comparison.verdict = Verdict::values;
    comparison.reason = fmt::format("{}", fmt::join(reasons, "; "));
}

}  // namespace

Comparison compare(const Samples& a, const Samples& b, const Tolerance& tolerance) {
    if (auto refused = refusal(a, b)) return *std::move(refused);
    Comparison comparison;
    comparison.pixels = Plane<float>(a.size);
    double squares = 0;
    for (std::size_t k = 0; k < a.values.size(); ++k) {
        const double difference = std::abs(static_cast<double>(a.values[k]) - static_cast<double>(b.values[k]));
        comparison.mean += difference;
        squares += difference * difference;
        comparison.max = std::max(comparison.max, difference);
    }
    const auto count = static_cast<double>(std::max<std::size_t>(1, a.values.size()));
    comparison.mean /= count;
    comparison.rms = std::sqrt(squares / count);
    comparison.psnr = comparison.rms > 0 ? -20 * std::log10(comparison.rms) : std::numeric_limits<double>::infinity();

    for (int j = 0; j < a.size.height; ++j) {
        for (int i = 0; i < a.size.width; ++i) comparison.pixels.at(i, j) = largest(a.at(i, j), b.at(i, j));
    }
    const auto pixels = comparison.pixels.pixels();
    comparison.off = std::ranges::count_if(pixels, [&](float value) { return value > tolerance.level; });
    comparison.percent =
        100 * static_cast<double>(comparison.off) / static_cast<double>(std::max<std::size_t>(1, pixels.size()));
    comparison.patch = worst_patch(comparison.pixels);
    comparison.worst = worst_of(a, b, comparison.pixels);
    judge(comparison, tolerance);
    return comparison;
}

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
    // A character is about twice as high as wide.
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
