#include "core/fields/object.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <span>
#include <utility>

#include <opencv2/core.hpp>

#include "core/base/cv_view.h"
#include "core/fields/median_scene.h"
#include "core/fields/shadows.h"
#include "core/fields/thresholds.h"

namespace vvr::fields {

namespace {

/// The threshold of each pixel.
Plane<std::uint8_t> thresholds_of_pixels(Size size, const Plane<std::uint8_t>& noise, double least, double per_noise,
                                         double highest) {
    Plane<std::uint8_t> result(size, static_cast<std::uint8_t>(std::lround(least)));
    if (noise.empty()) return result;
    std::ranges::transform(noise.pixels(), result.pixels().begin(), [&](std::uint8_t median) {
        const double level = std::max(least, std::min(per_noise * median, highest));
        return static_cast<std::uint8_t>(std::lround(std::min(level, 255.0)));
    });
    return result;
}

/// Whether one of two pictures is in colour and the other has none, as when a camera changes to infrared or back.
bool is_other_mode(const Planes& a, const Planes& b) {
    return (has_colours_everywhere(a.colour) && !has_colours(b.colour)) ||
           (has_colours_everywhere(b.colour) && !has_colours(a.colour));
}

std::uint8_t value_of(int difference) {
    return static_cast<std::uint8_t>(std::min(thresholds.object.gain * difference, 255));
}

/// The object's values from differences: 0 below `weak`.
Plane<std::uint8_t> values_of(const Plane<std::uint8_t>& differences, const Plane<std::uint8_t>& weak) {
    auto result = Plane<std::uint8_t>::for_overwrite(differences.size());
    std::uint8_t* const out = result.pixels().data();
    const std::uint8_t* const in = differences.pixels().data();
    const std::uint8_t* const least = weak.pixels().data();
    const std::size_t count = differences.pixels().size();
    constexpr std::uint8_t half = 255 / thresholds.object.gain;
    // Plain byte arithmetic, which the compiler vectorizes.
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t value = in[i];
        const auto lit = static_cast<std::uint8_t>(std::min(value, half) * thresholds.object.gain);
        const auto shown = static_cast<std::uint8_t>(value > half ? 255 : lit);
        out[i] = value < least[i] ? std::uint8_t{0} : shown;
    }
    return result;
}

Plane<std::uint8_t> darker_in(const Plane<std::uint8_t>& frame, const Plane<std::uint8_t>& empty) {
    auto result = Plane<std::uint8_t>::for_overwrite(frame.size());
    std::ranges::transform(
        frame.pixels(), empty.pixels(), result.pixels().begin(),
        [](std::uint8_t now, std::uint8_t then) { return static_cast<std::uint8_t>(now < then ? 1 : 0); });
    return result;
}

void clear_outside(const Plane<std::uint8_t>& region, Plane<std::uint8_t>& plane) {
    if (region.empty()) return;
    std::uint8_t* const pixels = plane.pixels().data();
    const std::uint8_t* const inside = region.pixels().data();
    const std::size_t count = plane.pixels().size();
    for (std::size_t i = 0; i < count; ++i) {
        pixels[i] = inside[i] == 0 ? std::uint8_t{0} : pixels[i];
    }
}

}  // namespace

ObjectFinder::ObjectFinder(const FieldOptions& options, int threshold, const Reference& reference,
                           const Plane<std::uint8_t>& region, bool marks_darker)
    : illumination_(*options.illumination),
      norm_(norm_for(*options.norm, reference)),
      threshold_(threshold),
      min_area_(options.min_area),
      least_strong_(std::clamp(options.min_area / 5, 1, 4)),
      threshold_value_(value_of(threshold)),
      removes_shadows_(options.shadows->removes),
      marks_darker_(marks_darker),
      region_(region),
      looked_at_(region.empty() ? static_cast<double>(reference.grey.pixels().size())
                                : std::max(1, cv::countNonZero(cv_view(region)))) {
    const Size size = reference.grey.size();
    // If small blobs are kept, holes are too.
    holes_ = {.max_area = options.min_area > 0 ? size.width * size.height / thresholds.object.head : 0,
              .least = static_cast<int>(std::lround(thresholds.object.hole * threshold)),
              .value = threshold_value_};
    set_scene(smoothed(reference.grey, reference.colour, options.smooth), reference.noise);
    const ReferenceRow* const row = options.reference.row();
    if (row != nullptr && row->adapts) running_.emplace(reference_);
}

void ObjectFinder::set_scene(const Planes& scene, const Plane<std::uint8_t>& noise) {
    reference_ = scene;
    const Size size = scene.grey.size();
    const double scale = 1.0 * threshold_ / thresholds.object.usual;
    weak_ = thresholds_of_pixels(size, noise, thresholds.object.weak * threshold_, scale * thresholds.object.weak_noise,
                                 scale * thresholds.object.most_weak);
    strong_ = thresholds_of_pixels(size, noise, threshold_, scale * thresholds.object.strong_noise,
                                   scale * thresholds.object.most_strong);
    std::ranges::transform(strong_.pixels(), strong_.pixels().begin(), value_of);
}

IlluminationChange ObjectFinder::light_of(const Planes& frame, const Planes& reference) const {
    return illumination_.compensates ? estimate_illumination(reference, frame) : IlluminationChange{};
}

FoundObject ObjectFinder::compare(const Planes& frame, const Planes& reference, const IlluminationChange& light) const {
    const std::optional<Planes> lit = relit(reference, frame, light);
    const Planes& empty = lit ? *lit : reference;
    FoundObject found = compare_in_light(frame, empty);
    constexpr double middle = 128;
    found.middle_grey = light(middle);
    if (!illumination_.compensates) return found;
    const double share = cv::countNonZero(cv_view(found.values)) / looked_at_;
    if (share < illumination_.local || share == 0 || is_other_mode(frame, reference)) return found;
    const LocalLight local = local_light(empty, frame, found.values);
    if (local.explained < thresholds.light.least_explained) return found;
    found = compare_in_light(frame, relight(empty, local));
    found.other_light = local.changed;
    found.middle_grey = light(middle);
    return found;
}

FoundObject ObjectFinder::compare_in_light(const Planes& frame, const Planes& empty) const {
    const Plane<std::uint8_t> differences = norm_.difference(frame, empty);
    Plane<std::uint8_t> object = values_of(differences, weak_);
    clear_outside(region_, object);
    apply_hysteresis(object, strong_, least_strong_, min_area_);
    if (removes_shadows_) object = without_shadows(std::move(object), frame, empty);
    if (holes_.max_area > 0) fill_holes(object, differences, holes_);
    return {std::move(object), marks_darker_ ? darker_in(frame.grey, empty.grey) : Plane<std::uint8_t>{}};
}

Plane<std::uint8_t> ObjectFinder::without_shadows(Plane<std::uint8_t> object, const Planes& frame,
                                                  const Planes& empty) const {
    const Plane<std::uint8_t> before = object;
    const std::vector<ShadowPixel> shadow = extract_shadows(object, frame, empty, threshold_value_);
    if (shadow.empty()) return object;
    restore_small_blobs(object, before, thresholds.object.small * min_area_);
    apply_hysteresis(object, strong_, least_strong_, min_area_);
    restore_enclosed(object, shadow, std::max(object.width(), object.height()) / thresholds.object.half_car,
                     threshold_value_);
    return object;
}

FoundObject ObjectFinder::find(const Planes& frame) const {
    return compare(frame, reference_, light_of(frame, reference_));
}

FoundObject ObjectFinder::find_and_adapt(const Planes& frame, double seconds, bool turned) {
    const IlluminationChange light = light_of(frame, running_->now());
    FoundObject found = compare(frame, running_->now(), light);
    const double share = cv::countNonZero(cv_view(found.values)) / looked_at_;
    if (share < thresholds.object.some_changed) {
        changed_.reset();  // the scene is as before
        learnt_.clear();
    } else if (!changed_ && (turned || is_other_mode(frame, running_->now()))) {
        changed_ = seconds;
    }
    if (changed_) return learn(frame, seconds);
    running_->adapt(frame, found.values, light, seconds);
    if (std::min(share, running_->steady_pixels() / looked_at_) >= thresholds.object.most_changed)
        changed_ = seconds - thresholds.running.ghost;
    return found;
}

/// Collects frames of the changed scene. Nothing is found in them until there are enough.
FoundObject ObjectFinder::learn(const Planes& frame, double seconds) {
    if (learnt_.empty() || seconds - learnt_.back().pts >= thresholds.object.step)
        learnt_.push_back({.pts = seconds, .grey = frame.grey, .colour = frame.colour});
    if (seconds - learnt_.front().pts < thresholds.object.learning || learnt_.size() < thresholds.scene.fewest) {
        const Plane<std::uint8_t> nothing(frame.grey.size());
        return {nothing, marks_darker_ ? nothing : Plane<std::uint8_t>{}, true};
    }
    const Planes scene = lasting_reference(learnt_);
    set_scene(scene, noise_of(learnt_, scene, 0));
    running_.emplace(scene);
    learnt_.clear();
    FoundObject found = find(frame);
    found.scene = std::make_shared<const NewScene>(NewScene{scene, *std::exchange(changed_, {})});
    return found;
}

namespace {

/// The tiles of two frames.
class Tiles {
  public:
    Tiles(const Plane<std::uint8_t>& a, const Plane<std::uint8_t>& b) : a_(a), b_(b) {}

    int columns() const { return (a_.width() + tile_side - 1) / tile_side; }
    int rows() const { return (a_.height() + tile_side - 1) / tile_side; }

    /// The mean difference in a tile.
    float difference(int x, int y) const {
        const int right = std::min((x + 1) * tile_side, a_.width());
        const int bottom = std::min((y + 1) * tile_side, a_.height());
        int sum = 0;
        for (int j = y * tile_side; j < bottom; ++j) {
            const std::uint8_t* const a = a_.row(j).data();
            const std::uint8_t* const b = b_.row(j).data();
            for (int i = x * tile_side; i < right; ++i) sum += std::abs(a[i] - b[i]);
        }
        return static_cast<float>(sum) / static_cast<float>((bottom - y * tile_side) * (right - x * tile_side));
    }

  private:
    const Plane<std::uint8_t>& a_;
    const Plane<std::uint8_t>& b_;
};

/// The threshold of a tile's mean. At least a quarter of all tiles are quiet unless the camera moves; then the upper
/// bound applies. A sample of the tiles is enough.
float threshold_of(const Tiles& tiles) {
    std::vector<float> differences;
    for (int y = 0; y < tiles.rows(); ++y) {
        for (int x = y % 5; x < tiles.columns(); x += 5) differences.push_back(tiles.difference(x, y));
    }
    constexpr auto& motion = thresholds.motion;
    if (differences.empty()) return motion.least;
    const auto quiet = differences.begin() + std::ssize(differences) / 4;
    std::ranges::nth_element(differences, quiet);
    return std::clamp(motion.above_noise * *quiet + motion.excess, motion.least, motion.most);
}

/// A tile and its neighbours, clipped at the picture's edges.
struct Block {
    int left, right, top, bottom;

    Block(int x, int y, Size size)
        : left(std::max((x - 1) * tile_side, 0)),
          right(std::min((x + 2) * tile_side, size.width)),
          top(std::max((y - 1) * tile_side, 0)),
          bottom(std::min((y + 2) * tile_side, size.height)) {}
};

/// 1 for each tile that is occupied or next to an occupied one.
Plane<std::uint8_t> neighbourhood(const Plane<std::uint8_t>& tiles) {
    Plane<std::uint8_t> result(tiles.size());
    for (int y = 0; y < tiles.height(); ++y) {
        for (int x = 0; x < tiles.width(); ++x) {
            if (tiles.at(x, y) == 0) continue;
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, tiles.height() - 1); ++v) {
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, tiles.width() - 1); ++u) result.at(u, v) = 1;
            }
        }
    }
    return result;
}

}  // namespace

void mark_changes(const Plane<std::uint8_t>& other, const Plane<std::uint8_t>& here, const Plane<std::uint8_t>& object,
                  Plane<std::uint8_t>& changed) {
    const Plane<std::uint8_t> near_object = neighbourhood(occupied_tiles(object));
    if (std::ranges::none_of(near_object.pixels(), [](int near) { return near == 1; })) return;
    const Tiles tiles(other, here);
    const float threshold = threshold_of(tiles);
    for (int y = 0; y < tiles.rows(); ++y) {
        for (int x = 0; x < tiles.columns(); ++x) {
            if (near_object.at(x, y) == 0 || tiles.difference(x, y) < threshold) continue;
            const Block block(x, y, object.size());
            for (int j = block.top; j < block.bottom; ++j) {
                std::copy(object.row(j).begin() + block.left, object.row(j).begin() + block.right,
                          changed.row(j).begin() + block.left);
            }
        }
    }
}

}  // namespace vvr::fields
