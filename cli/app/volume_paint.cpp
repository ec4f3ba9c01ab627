#include "cli/app/volume_paint.h"

#include <algorithm>
#include <cmath>

#include "core/fields/filter.h"
#include "core/scene/theme.h"
#include "core/scene/transfer_function.h"

namespace vvr::app {

namespace {

// Pixels per frame: up to the first nothing moves, from the second on it does.
constexpr float resting = 0.2F;
constexpr float moving = 0.6F;

Bgr bgr_of(const glm::vec3& colour) {
    const glm::vec3 level = glm::clamp(colour, 0.F, 1.F) * 255.F + 0.5F;
    return {static_cast<std::uint8_t>(level.b), static_cast<std::uint8_t>(level.g), static_cast<std::uint8_t>(level.r)};
}

}  // namespace

scene::TransferFunction second_transfer_of(const RenderJob& job) {
    if (job.look.transfer) return *job.look.transfer;
    const std::string_view own = job.fields.second->transfer;
    return scene::find_transfer(own.empty() ? "viridis" : std::string(own));
}

VolumePaint::VolumePaint(const RenderJob& job) : job_(job), row_(*job.look.colour) {
    if (row_.filter == nullptr) return;
    const scene::TransferFunction transfer = second_transfer_of(job);
    for (std::size_t value = 0; value < of_value_.size(); ++value) {
        of_value_[value] = bgr_of(glm::vec3(transfer.at(static_cast<double>(value))));
    }
}

Bgr VolumePaint::colour_of_flow(float u, float v) const {
    const scene::Theme& theme = job_.look.theme;
    const float speed = std::hypot(u, v);
    if (row_.of_direction) {
        const float share = std::clamp((speed - resting) / (moving - resting), 0.F, 1.F);
        if (share == 0) return bgr_of(theme.unowned);
        return bgr_of(glm::mix(theme.unowned, scene::direction_colour({u, v}), share));
    }
    const glm::vec2 range = job_.picture.glyphs.speed_range;
    return bgr_of(glm::mix(theme.slow, theme.fast, std::clamp((speed - range.x) / (range.y - range.x), 0.F, 1.F)));
}

const Plane<Bgr>& VolumePaint::operator()(const video::Frame& frame, const fields::Field& field) {
    if (row_.drawn != gl::VolumeColour::own) return painted_;
    if (row_.needs_pictures) return frame.colour;
    if (painted_.size() != field.scalar.size()) painted_ = Plane<Bgr>(field.scalar.size());
    const auto into = painted_.pixels().begin();
    if (row_.filter != nullptr) {
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
