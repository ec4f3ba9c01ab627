#include "tests/scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "tests/scene/camera.h"
#include "tests/scene/canvas.h"
#include "tests/scene/happenings.h"
#include "tests/scene/texture.h"

namespace vvr::generator {
namespace {

struct Entry {
    std::string_view name;
    Scene (*make)(const Options&);
};
constexpr std::array table{
    Entry{"left_bag", make_left_bag},
    Entry{"left_box", make_left_box},
    Entry{"fall_on_floor", make_fall_on_floor},
    Entry{"walkers", make_walkers},
    Entry{"two_walkers_cross", make_two_walkers_cross},
    Entry{"spinning_sphere", make_spinning_sphere},
    Entry{"shifted_texture", make_shifted_texture},
    Entry{"still", make_still},
    Entry{"one_object_a_second", make_one_object_a_second},
    Entry{"walks_by", make_walks_by},
    Entry{"walks_by_shaken", [](const Options& options) { return make_shaken(make_walks_by(options)); }},
    Entry{"stands", make_stands},
    Entry{"comes_closer", make_comes_closer},
    Entry{"group_splits", make_group_splits},
    Entry{"train", make_train},
    Entry{"taken_box", make_taken_box},
    Entry{"rain", make_rain},
    Entry{"balloons", make_balloons},
    Entry{"crowd", make_crowd},
    Entry{"clock", make_clock}};

class Told final : public Story {
  public:
    Told(std::function<Plane<Bgr>(int)> paint, std::function<Truth(int)> truth)
        : paint_(std::move(paint)), truth_(std::move(truth)) {}
    Plane<Bgr> paint(int frame) const override { return paint_(frame); }
    Truth truth(int frame) const override { return truth_(frame); }

  private:
    std::function<Plane<Bgr>(int)> paint_;
    std::function<Truth(int)> truth_;
};

/// Four even numbers added up are close to normal, and a sum of bits of one hash is cheap.
double normal(std::uint64_t value) {
    const std::uint64_t bits = hash(value);
    double sum = 0;
    for (int shift = 0; shift < 64; shift += 16) sum += static_cast<double>((bits >> shift) & 0xffff) / 65536;
    return (sum - 2) * std::sqrt(3.0);
}

}  // namespace

Plane<Bgr> Scene::frame(int i) const {
    auto picture = story_->paint(i);
    double light = options_.frames > 1 ? options_.drift * i / (options_.frames - 1) : 0;
    if (i >= options_.jump_at) light += options_.jump;
    if (light == 0 && options_.noise <= 0) return picture;

    std::uint64_t pixel = hash(options_.seed * 0x10001 + static_cast<std::uint64_t>(i));
    for (Bgr& colour : picture.pixels()) {
        const double add = light + (options_.noise > 0 ? options_.noise * normal(pixel++) : 0);
        for (auto& channel : colour) channel = to_level(channel + add);
    }
    return picture;
}

Scene told(const Options& options, std::function<Plane<Bgr>(int)> paint, std::function<Truth(int)> truth) {
    return {options, std::make_shared<Told>(std::move(paint), std::move(truth))};
}

Scene make_scene(std::string_view name, const Options& options) {
    std::string names;
    for (const auto& entry : table) {
        if (entry.name == name) return entry.make(options);
        names += (names.empty() ? "" : ", ") + std::string(entry.name);
    }
    throw std::invalid_argument("no scene named '" + std::string(name) + "'; there are " + names);
}

}  // namespace vvr::generator
