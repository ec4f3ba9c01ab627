#include "core/bricks/volume.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"

namespace vvr {

namespace {

void keep_stronger(Plane<std::uint8_t>& kept, const Plane<std::uint8_t>& other) {
    std::ranges::transform(kept.pixels(), other.pixels(), kept.pixels().begin(),
                           [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
}

}  // namespace

Volume::Volume(Size size, std::int64_t capacity, std::int64_t step, std::int64_t seed_interval)
    : size_(size), capacity_(capacity), step_(step), seed_interval_(seed_interval) {
    if (capacity < 2 || step < 1 || seed_interval < 1) {
        throw Error(ErrorKind::usage, fmt::format("a volume needs room for 2 layers and a step of 1 frame, not {} and {}",
                                                  capacity, step));
    }
}

void Volume::add(const Field& field) {
    if (field.scalar.size() != size_) {
        throw Error(ErrorKind::not_video, fmt::format("frame {} has a field of {}x{}, the volume's frames have {}x{}",
                                                      field.index, field.scalar.width(), field.scalar.height(),
                                                      size_.width, size_.height));
    }
    if (layers_.empty() || layers_.back().frames == step_) {
        if (layers() == capacity_) join_pairs();
    }
    if (layers_.empty() || layers_.back().frames == step_) {
        layers_.push_back({field.index, 1, field.pts, field.pts, field.scalar});
    } else {
        Layer& layer = layers_.back();
        keep_stronger(layer.scalar, field.scalar);
        layer.last_pts = field.pts;
        ++layer.frames;
    }
    if (seeded(frames_)) {
        for (const Seed& seed : field.seeds) seeds_.push_back({frames_, seed});
        if (keeps_flow_ && !field.flow.u.empty()) flow_.add(frames_, field.flow);
    }
    ++frames_;
}

double Volume::t_of_frame(double frame) const {
    // The last layer may hold fewer frames than the others; it is as thick as they are all the same.
    return (frame + 0.5) / static_cast<double>(layers() * step_);
}

glm::dvec3 Volume::c_of(const glm::dvec3& point) const {
    return {1 - (point.x + 0.5) / size_.width, 1 - (point.y + 0.5) / size_.height, t_of_frame(point.z)};
}

glm::dvec3 Volume::c_vector(const glm::dvec3& vector) const {
    return {-vector.x / size_.width, -vector.y / size_.height, vector.z / static_cast<double>(layers() * step_)};
}

bool Volume::seeded(std::int64_t frame) const {
    // By the frame's index in the clip, as flow is: a clip that begins in the middle keeps them in step.
    return (layers_.front().first_frame + frame) % seed_interval_ == 0;
}

void Volume::release_before(std::int64_t layer) {
    for (std::int64_t i = 0; i < std::min(layer, layers()); ++i) layers_[static_cast<std::size_t>(i)].scalar = {};
}

void Volume::join_pairs() {
    std::vector<Layer> joined;
    joined.reserve(layers_.size());
    for (std::size_t i = 0; i < layers_.size(); i += 2) {
        Layer layer = std::move(layers_[i]);
        if (i + 1 < layers_.size()) {
            keep_stronger(layer.scalar, layers_[i + 1].scalar);
            layer.frames += layers_[i + 1].frames;
            layer.last_pts = layers_[i + 1].last_pts;
        }
        joined.push_back(std::move(layer));
    }
    layers_ = std::move(joined);
    step_ *= 2;
    seed_interval_ *= 2;
    std::erase_if(seeds_, [this](const FrameSeed& seed) { return !seeded(seed.frame); });
    flow_.erase_if([this](std::int64_t frame) { return !seeded(frame); });
}

std::span<const std::uint8_t> BrickTexels::layer(std::int64_t i) const {
    const std::size_t area = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    return std::span(texels).subspan(static_cast<std::size_t>(i) * area, area);
}

BrickTexels brick_texels(const Volume& volume, const Brick& brick) {
    BrickTexels result{brick, volume.size(), {}};
    const std::size_t area = static_cast<std::size_t>(volume.size().width) * static_cast<std::size_t>(volume.size().height);
    result.texels.resize(area * static_cast<std::size_t>(result.layers()));
    for (std::int64_t i = 0; i < result.layers(); ++i) {
        const std::int64_t layer = std::clamp<std::int64_t>(brick.first + i - 1, 0, volume.layers() - 1);
        // Both axes run against the image's, so a layer is its pixels from the last to the first.
        std::ranges::reverse_copy(volume.layer(layer).scalar.pixels(),
                                  result.texels.begin() + static_cast<std::ptrdiff_t>(area * static_cast<std::size_t>(i)));
    }
    return result;
}

}  // namespace vvr
