#include "cli/app/volume_paint.h"

#include <algorithm>
#include <cmath>

#include "core/scene/theme.h"

namespace vvr::app {

namespace {

// Pixels per frame: no motion up to the first, motion from the second on.
constexpr float resting = 0.2F;
constexpr float moving = 0.6F;

}  // namespace

VolumePaint::VolumePaint(const Plan& plan) : plan_(plan) {
    if (plan.second == nullptr) return;
    for (std::size_t value = 0; value < of_value_.size(); ++value) {
        of_value_[value] = scene::bgr_of(glm::vec3(plan.second_transfer.at(static_cast<double>(value))));
    }
}

Bgr VolumePaint::colour_of_flow(float u, float v) const {
    const scene::Theme& theme = plan_.job.look.theme;
    const float speed = std::hypot(u, v);
    if (plan_.colour->of_direction) {
        const float share = std::clamp((speed - resting) / (moving - resting), 0.F, 1.F);
        if (share == 0) return scene::bgr_of(theme.unowned);
        return scene::bgr_of(glm::mix(theme.unowned, scene::direction_colour({u, v}), share));
    }
    const glm::vec2 range = plan_.picture.glyphs.speed_range;
    return scene::bgr_of(
        glm::mix(theme.slow, theme.fast, std::clamp((speed - range.x) / (range.y - range.x), 0.F, 1.F)));
}

const Plane<Bgr>& VolumePaint::operator()(const video::Frame& frame, const fields::Field& field) {
    if (plan_.colour->drawn != gl::VolumeColour::own) return painted_;
    if (plan_.colour->needs_pictures) return frame.colour;
    if (painted_.size() != field.scalar.size()) painted_ = Plane<Bgr>(field.scalar.size());
    const auto into = painted_.pixels().begin();
    if (plan_.second != nullptr) {
        std::ranges::transform(field.second.pixels(), into, [this](std::uint8_t value) { return of_value_[value]; });
    } else if (field.flow.u.empty()) {
        std::ranges::fill(painted_.pixels(), colour_of_flow(0, 0));
    } else {
        std::ranges::transform(field.flow.u.pixels(), field.flow.v.pixels(), into,
                               [this](float u, float v) { return colour_of_flow(u, v); });
    }
    return painted_;
}

}  // namespace vvr::app
