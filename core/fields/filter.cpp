#include "core/fields/filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/background_segm.hpp>

#include "core/base/cv_view.h"
#include "core/base/setting.h"
#include "core/fields/illumination.h"
#include "core/fields/thresholds.h"

namespace vvr::fields {
namespace {

// Filters of the difference object.

Plane<std::uint8_t> difference(const FilterInput& input) {
    return input.object;
}

Plane<std::uint8_t> hull(const FilterInput& input) {
    Plane<std::uint8_t> result(input.object.size());
    std::ranges::transform(input.object.pixels(), result.pixels().begin(),
                           [](std::uint8_t p) { return static_cast<std::uint8_t>(p == 0 ? 0 : 255); });
    return result;
}

// Before the first frame nothing was covered.
Plane<std::uint8_t> bands(const FilterInput& input) {
    Plane<std::uint8_t> result(input.object.size());
    const Plane<std::uint8_t> nothing(input.previous_object == nullptr ? input.object.size() : Size{});
    const Plane<std::uint8_t>& before = input.previous_object == nullptr ? nothing : *input.previous_object;
    std::ranges::transform(
        input.object.pixels(), before.pixels(), result.pixels().begin(),
        [](std::uint8_t now, std::uint8_t then) { return static_cast<std::uint8_t>(band_of(then != 0, now != 0)); });
    return result;
}

Plane<std::uint8_t> signed_difference(const FilterInput& input) {
    Plane<std::uint8_t> result(input.object.size());
    std::ranges::transform(input.object.pixels(), input.darker.pixels(), result.pixels().begin(),
                           [](std::uint8_t value, std::uint8_t darker) {
                               const int half = (value + 1) / 2;
                               const int side =
                                   darker != 0 ? std::max(sign_middle - half, 1) : std::min(sign_middle + half, 255);
                               return static_cast<std::uint8_t>(value == 0 ? 0 : side);
                           });
    return result;
}

// Filters of the frame, its predecessor and the flow.

// Sobel masks give four times the height of a step; a quarter of that maps black beside white to 255.
Plane<std::uint8_t> edges(const FilterInput& input) {
    cv::Mat x, y, length;
    const cv::Mat grey = cv_view(input.smooth.grey);
    cv::Sobel(grey, x, CV_32F, 1, 0, 3, 0.25, 0, cv::BORDER_REPLICATE);
    cv::Sobel(grey, y, CV_32F, 0, 1, 3, 0.25, 0, cv::BORDER_REPLICATE);
    cv::magnitude(x, y, length);
    Plane<std::uint8_t> result(input.smooth.grey.size());
    cv::Mat out = cv_view(result);
    length.convertTo(out, CV_8U);
    return result;
}

Plane<std::uint8_t> luminance(const FilterInput& input) {
    return input.frame.grey;
}

Plane<std::uint8_t> flow_magnitude(const FilterInput& input) {
    Plane<std::uint8_t> result(input.frame.grey.size());
    if (input.flow.u.empty()) return result;
    std::ranges::transform(input.flow.u.pixels(), input.flow.v.pixels(), result.pixels().begin(), [](float u, float v) {
        const float level = thresholds.flow.levels_per_pixel * std::sqrt(u * u + v * v);
        return static_cast<std::uint8_t>(std::lround(std::min(level, 255.F)));
    });
    return result;
}

/// The filter of a function that needs no options and keeps nothing between frames.
template <Plane<std::uint8_t> (*compute)(const FilterInput&)>
Filter stateless(const FieldOptions&) {
    return compute;
}

Filter make_temporal(const FieldOptions& options) {
    return [&illumination = *options.illumination, &norm = *options.norm](const FilterInput& input) {
        if (input.previous == nullptr) return Plane<std::uint8_t>(input.frame.grey.size());
        const IlluminationChange light =
            illumination.compensates ? estimate_illumination(*input.previous, input.smooth) : IlluminationChange{};
        const std::optional<Planes> lit = relit(*input.previous, input.smooth, light);
        return norm_for(norm, input.smooth).difference(input.smooth, lit ? *lit : *input.previous);
    };
}

// OpenCV's adaptive background models, with its defaults. Their shadow detection is off, because it marks shadows with
// a third value.

Filter background_filter(cv::Ptr<cv::BackgroundSubtractor> model) {
    return [model = std::move(model), random = cv::RNG()](const FilterInput& input) mutable {
        Plane<std::uint8_t> result(input.frame.grey.size());
        cv::Mat out = cv_view(result);
        // KNN uses the random numbers of the calling thread, and frames run on any thread.
        std::swap(cv::theRNG(), random);
        model->apply(input.smooth.colour.empty() ? cv_view(input.smooth.grey) : cv_view(input.smooth.colour), out);
        std::swap(cv::theRNG(), random);
        return result;
    };
}

Filter make_mog2(const FieldOptions&) {
    return background_filter(
        cv::createBackgroundSubtractorMOG2(thresholds.background.history, thresholds.background.variances, false));
}

Filter make_knn(const FieldOptions&) {
    return background_filter(cv::createBackgroundSubtractorKNN(thresholds.background.history,
                                                               thresholds.background.squared_distance, false));
}

Filter make_given(const FieldOptions& options) {
    return [files = open_field_files(options.given_folder), read = options.read_given](const FilterInput& input) {
        return read(files.of(input.frame.index), input.frame.grey.size());
    };
}

constexpr std::array filter_rows{
    FilterRow{"difference",
              "what differs from the empty scene",
              {.object = true, .colour = true, .shows_object = true, .threshold = thresholds.object.usual},
              stateless<difference>},
    FilterRow{"temporal",
              "what differs from the frame before",
              {.colour = true, .previous = true, .threshold = 16, .gain = 2},
              make_temporal},
    FilterRow{"hull",
              "the silhouette of what differs from the empty scene: over time, its visual hull",
              {.object = true, .colour = true, .shows_object = true, .threshold = thresholds.object.usual},
              stateless<hull>},
    FilterRow{"bands",
              "the silhouette in three bands: uncovered 85, still covered 170, newly covered 255",
              {.object = true,
               .colour = true,
               .previous = true,
               .shows_object = true,
               .values = Values::band,
               .threshold = thresholds.object.usual},
              stateless<bands>,
              "bands"},
    FilterRow{"signed",
              "what differs from the empty scene, darker 127 to 1, brighter 129 to 255",
              {.object = true,
               .colour = true,
               .shows_object = true,
               .darker = true,
               .values = Values::sign,
               .threshold = thresholds.object.usual},
              stateless<signed_difference>,
              "signed"},
    FilterRow{"edges", "how steeply the brightness changes", {.min_area = false, .threshold = 24}, stateless<edges>},
    FilterRow{"flow",
              "how fast it moves: 24 levels per pixel per frame",
              {.flow = true, .threshold = 12},
              stateless<flow_magnitude>},
    FilterRow{"luminance", "the video itself", {.min_area = false}, stateless<luminance>},
    FilterRow{"mog2",
              "OpenCV's background model of Gaussian mixtures",
              {.colour = true, .in_order = true, .shows_object = true},
              make_mog2},
    FilterRow{"knn",
              "OpenCV's background model of nearest neighbours",
              {.colour = true, .in_order = true, .shows_object = true},
              make_knn},
    FilterRow{"given",
              "a field of another program, from --field",
              {.colour = true, .min_area = false, .shows_object = true, .given = true},
              make_given},
};

}  // namespace

FrameFiles open_field_files(const std::filesystem::path& folder) {
    return {"field", folder, {".png", ".exr", ".tif", ".tiff"}};
}

std::span<const FilterRow> filters() {
    return filter_rows;
}

const FilterRow& row_of(Name<FilterRow> name) {
    return choose("filter", name.text, filters());
}

}  // namespace vvr::fields
