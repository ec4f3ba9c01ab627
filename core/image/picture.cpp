#include "core/image/picture.h"

#include <cmath>
#include <limits>
#include <span>

#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"

namespace vvr::image {

void put(Metadata& settings, std::string_view name, const std::string& value) {
    const auto known = std::ranges::find(settings, name, &Metadata::value_type::first);
    if (known == settings.end()) {
        settings.emplace_back(name, value);
    } else {
        known->second = value;
    }
}

std::string value_of(const Metadata& settings, std::string_view name) {
    const auto found = std::ranges::find(settings, name, &Metadata::value_type::first);
    return found == settings.end() ? "" : found->second;
}

Picture to_picture(Plane<Rgba> drawn) {
    return {std::move(drawn)};
}

void draw_line(Picture& picture, const glm::dvec2& from, const glm::dvec2& to, double width, const Rgba& colour) {
    Plane<Rgba>& pixels = picture.pixels;
    const double reach = width / 2 + 1;
    const auto low = [reach](double a, double b) {
        return std::max(0, static_cast<int>(std::floor(std::min(a, b) - reach)));
    };
    const auto high = [reach](double a, double b, int side) {
        return std::min(side - 1, static_cast<int>(std::ceil(std::max(a, b) + reach)));
    };
    const glm::dvec2 along = to - from;
    const double squared = glm::dot(along, along);
    for (int j = low(from.y, to.y); j <= high(from.y, to.y, pixels.height()); ++j) {
        for (int i = low(from.x, to.x); i <= high(from.x, to.x, pixels.width()); ++i) {
            const glm::dvec2 point(i, j);
            const double at = squared > 0 ? std::clamp(glm::dot(point - from, along) / squared, 0.0, 1.0) : 0;
            const double cover = std::clamp(width / 2 + 0.5 - glm::distance(point, from + at * along), 0.0, 1.0);
            Rgba& pixel = pixels.at(i, j);
            const auto over = static_cast<float>(cover);
            pixel += over * (colour - pixel * colour.a);
        }
    }
}

}  // namespace vvr::image

template <>
struct vvr::CvType<vvr::image::Rgba> {
    static constexpr int value = CV_32FC4;
};

namespace vvr::image {

template <class T>
Plane<T> resized(const Plane<T>& plane, Size size) {
    if (plane.size() == size) return plane;
    auto result = Plane<T>::for_overwrite(size);
    cv::Mat to = cv_view(result);
    const bool smaller = size.width <= plane.width() && size.height <= plane.height();
    cv::resize(cv_view(plane), to, to.size(), 0, 0, smaller ? cv::INTER_AREA : cv::INTER_LINEAR);
    return result;
}

template Plane<std::uint8_t> resized(const Plane<std::uint8_t>&, Size);
template Plane<Bgr> resized(const Plane<Bgr>&, Size);
template Plane<Rgba> resized(const Plane<Rgba>&, Size);

namespace {

template <class T>
std::vector<Plane<T>> levels_of(const Plane<T>& picture) {
    std::vector<Plane<T>> levels;
    const Plane<T>* before = &picture;
    while (before->width() > 1 || before->height() > 1) {
        levels.push_back(resized(*before, {std::max(1, before->width() / 2), std::max(1, before->height() / 2)}));
        before = &levels.back();
    }
    return levels;
}

}  // namespace

std::vector<Plane<std::uint8_t>> mip_levels(const Plane<std::uint8_t>& picture) {
    return levels_of(picture);
}

std::vector<Plane<Bgr>> mip_levels(const Plane<Bgr>& picture) {
    return levels_of(picture);
}

namespace {

constexpr std::size_t most_colours = 256;
// Upper bits per channel. Colours with the same upper bits are treated as one.
constexpr int bits = 6;

std::array<int, 3> levels(const Rgba& pixel) {
    return {to_byte(pixel.r), to_byte(pixel.g), to_byte(pixel.b)};
}

std::size_t bin_of(const std::array<int, 3>& colour) {
    std::size_t bin = 0;
    for (const int of : colour) bin = (bin << bits) | static_cast<std::size_t>(of >> (8 - bits));
    return bin;
}

struct Entry {
    std::array<double, 3> colour{};
    double pixels = 0;
};

std::vector<Entry> histogram(const Picture& picture) {
    std::vector<Entry> bins(std::size_t{1} << (3 * bits));
    for (const Rgba& pixel : picture.pixels.pixels()) {
        const std::array<int, 3> colour = levels(pixel);
        Entry& bin = bins[bin_of(colour)];
        for (std::size_t c = 0; c < 3; ++c) bin.colour[c] += colour[c];
        ++bin.pixels;
    }
    std::erase_if(bins, [](const Entry& bin) { return bin.pixels == 0; });
    for (Entry& bin : bins) {
        for (double& value : bin.colour) value /= bin.pixels;
    }
    return bins;
}

/// A box of colours, which one palette colour represents.
struct Box {
    std::span<Entry> entries;
    std::array<double, 3> mean{};
    std::size_t widest = 0;
    double error = 0;  ///< squared error along the channel where it is largest

    explicit Box(std::span<Entry> inside) : entries(inside) {
        double pixels = 0;
        std::array<double, 3> squares{};
        for (const Entry& entry : entries) {
            // The square root leaves colours for small objects in front of a large plain background.
            const double weight = std::sqrt(entry.pixels);
            pixels += weight;
            for (std::size_t c = 0; c < 3; ++c) {
                mean[c] += weight * entry.colour[c];
                squares[c] += weight * entry.colour[c] * entry.colour[c];
            }
        }
        for (std::size_t c = 0; c < 3; ++c) {
            mean[c] /= pixels;
            squares[c] -= pixels * mean[c] * mean[c];
        }
        widest = static_cast<std::size_t>(std::ranges::max_element(squares) - squares.begin());
        error = entries.size() > 1 ? squares[widest] : 0;
    }
};

}  // namespace

Palette::Palette(const Picture& picture) : known_(std::size_t{1} << (3 * bits), -1) {
    std::vector<Entry> entries = histogram(picture);
    std::vector<Box> boxes = {Box(entries)};
    while (boxes.size() < most_colours) {
        const auto worst = std::ranges::max_element(boxes, {}, &Box::error);
        if (worst->error <= 0) break;
        const std::size_t c = worst->widest;
        const std::span<Entry> all = worst->entries;
        const auto upper = std::partition(
            all.begin(), all.end(), [cut = worst->mean[c], c](const Entry& entry) { return entry.colour[c] <= cut; });
        if (upper == all.begin() || upper == all.end()) break;
        *worst = Box(std::span(all.begin(), upper));
        boxes.emplace_back(std::span(upper, all.end()));
    }
    for (const Box& box : boxes) {
        Colour colour;
        std::ranges::transform(box.mean, colour.begin(),
                               [](double value) { return static_cast<std::uint8_t>(std::lround(value)); });
        colours_.push_back(colour);
    }
}

std::uint8_t Palette::nearest(const Rgba& pixel) {
    const std::array<int, 3> colour = levels(pixel);
    int& answer = known_[bin_of(colour)];
    if (answer < 0) {
        int least = std::numeric_limits<int>::max();
        for (std::size_t i = 0; i < colours_.size(); ++i) {
            int away = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const int step = colours_[i][c] - colour[c];
                away += step * step;
            }
            if (away < least) {
                least = away;
                answer = static_cast<int>(i);
            }
        }
    }
    return static_cast<std::uint8_t>(answer);
}

}  // namespace vvr::image
