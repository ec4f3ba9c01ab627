#include "core/bricks/volume.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"

namespace vvr {

namespace {

/// Pixel by pixel, where either has something.
SparsePlane joined_planes(Values values, const SparsePlane& before, const SparsePlane& after) {
    SparsePlane result(before.size());
    const auto visit = [&](const SparsePlane& plane) {
        plane.each_run([&](int column, int row, std::span<const std::uint8_t> run) {
            for (std::size_t i = 0; i < run.size(); ++i, ++column) {
                result.set(column, row, joined(values, before.at(column, row), after.at(column, row)));
            }
        });
    };
    visit(before);
    visit(after);
    return result;
}

/// Joins two layers' values; each voxel keeps the colour and the owner of the greater one, the first of two alike.
void join(Values kind, Layer& kept, const SparsePlane& scalar, const Plane<Bgr>& colour, const OwnerPlane& owner) {
    if (!colour.empty() || !owner.empty()) {
        scalar.each_run([&](int column, int row, std::span<const std::uint8_t> values) {
            for (const std::uint8_t value : values) {
                if (value > kept.scalar.at(column, row)) {
                    if (!colour.empty()) kept.colour.at(column, row) = colour.at(column, row);
                    if (!owner.empty()) kept.owner.set(column, row, owner.at(column, row));
                }
                ++column;
            }
        });
    }
    if (kind == Values::strength) {
        kept.scalar.keep_greater(scalar);
    } else {
        kept.scalar = joined_planes(kind, kept.scalar, scalar);
    }
}

void pass_over(Layer& layer, double seconds, const LeftOut& longest) {
    layer.left_out += seconds;
    if (longest.length() > layer.longest.length()) layer.longest = longest;
}

}  // namespace

Volume::Volume(Size size, std::int64_t capacity, std::int64_t step, std::int64_t seed_interval)
    : size_(size), capacity_(capacity), step_(step), seed_interval_(seed_interval) {
    if (capacity < 2 || step < 1 || seed_interval < 1) {
        throw Error(
            ErrorKind::usage,
            fmt::format("a volume needs room for 2 layers and a step of 1 frame, not {} and {}", capacity, step));
    }
}

void Volume::add(const Field& field, const Plane<Bgr>& colour, std::span<const LabelRun> owners) {
    if (field.scalar.size() != size_) {
        throw Error(ErrorKind::not_video,
                    fmt::format("frame {} has a field of {}x{}, the volume's frames have {}x{}", field.index,
                                field.scalar.width(), field.scalar.height(), size_.width, size_.height));
    }
    if (frames_ == 0) coloured_ = !colour.empty();
    if (colour.size() != (coloured_ ? size_ : Size{})) {
        throw Error(
            ErrorKind::not_video,
            fmt::format("frame {} has a colour picture of {}x{}, the volume's frames have {}x{}", field.index,
                        colour.width(), colour.height(), coloured_ ? size_.width : 0, coloured_ ? size_.height : 0));
    }
    if (layers_.empty() || layers_.back().frames == step_) {
        if (layers() == capacity_) join_pairs();
    }
    const LeftOut passed = frames_ > 0 && field.index != next_index_ ? LeftOut{last_pts_, field.pts} : LeftOut{};
    SparsePlane scalar(field.scalar);
    OwnerPlane owner = owners_in(owners, scalar);
    if (layers_.empty() || layers_.back().frames == step_) {
        layers_.push_back({field.index, field.index, 1, field.pts, field.pts, 0, passed.length(), passed,
                           std::move(scalar), colour, std::move(owner)});
    } else {
        Layer& layer = layers_.back();
        join(values_, layer, scalar, colour, owner);
        layer.last_frame = field.index;
        layer.last_pts = field.pts;
        pass_over(layer, passed.length(), passed);
        ++layer.frames;
    }
    next_index_ = field.index + 1;
    last_pts_ = field.pts;
    if (field.index % seed_interval_ == 0) {
        seeded_.push_back({frames_, field.index});
        for (const Seed& seed : field.seeds) seeds_.push_back({frames_, seed});
        if (keeps_flow_ && !field.flow.u.empty()) flow_.add(frames_, field.flow);
    }
    ++frames_;
}

void Volume::take_out(std::size_t track) {
    const std::uint16_t number = owners_.number_of(track);
    if (number == 0) return;
    for (Layer& layer : layers_) {
        const OwnerPlane owners = layer.owner;
        owners.each_run([&](int column, int row, std::span<const std::uint16_t> run) {
            for (std::size_t i = 0; i < run.size(); ++i) {
                if (run[i] != number) continue;
                layer.owner.set(column + static_cast<int>(i), row, 0);
                layer.scalar.set(column + static_cast<int>(i), row, 0);
            }
        });
    }
}

void Volume::put_in(std::size_t track, const PixelBox& box, const Plane<std::uint8_t>& values, double first,
                    double last) {
    const std::uint16_t number = owners_.number_of(track);
    if (number == 0) return;
    for (Layer& layer : layers_) {
        if (layer.last_pts < first || layer.pts > last) continue;
        for (int j = 0; j < values.height(); ++j) {
            for (int i = 0; i < values.width(); ++i) {
                const std::uint8_t value = values.at(i, j);
                if (value <= layer.scalar.at(box.left + i, box.top + j)) continue;
                layer.scalar.set(box.left + i, box.top + j, value);
                layer.owner.set(box.left + i, box.top + j, number);
            }
        }
    }
}

void Volume::add_missing(std::int64_t index, double pts) {
    Field nothing;
    nothing.index = index;
    next_index_ = index;
    nothing.pts = pts;
    nothing.scalar = Plane<std::uint8_t>(size_);
    add(nothing, coloured_ ? Plane<Bgr>(size_) : Plane<Bgr>{});
    ++layers_.back().missing;
}

/// Whose the pixels of a field are; empty where that isn't kept.
OwnerPlane Volume::owners_in(std::span<const LabelRun> runs, const SparsePlane& scalar) {
    if (!keeps_owners_) return {};
    if (owners_.room() < runs.size()) {
        std::vector<bool> used(std::size_t{1} << 16U);
        for (const Layer& layer : layers_) {
            layer.owner.each_run([&](int, int, std::span<const std::uint16_t> numbers) {
                for (const std::uint16_t number : numbers) used[number] = true;
            });
        }
        owners_.keep_only(used);
    }
    return owners_.pixels_of(runs, scalar);
}

std::int64_t Volume::missing() const {
    std::int64_t missing = 0;
    for (const Layer& layer : layers_) missing += layer.missing;
    return missing;
}

double Volume::left_out() const {
    double seconds = 0;
    for (const Layer& layer : layers_) seconds += layer.left_out;
    return seconds;
}

double Volume::t_of_frame(double frame) const {
    // The last layer may hold fewer frames than the others; it is as thick as they are all the same.
    return (frame + 0.5) / static_cast<double>(span() * step_);
}

/// The last layer that begins at or before the moment, or the first.
std::int64_t Volume::layer_of(double seconds) const {
    const auto after = std::ranges::upper_bound(layers_, seconds, {}, &Layer::pts);
    return std::max<std::int64_t>(0, after - layers_.begin() - 1);
}

bool Volume::is_left_out(double seconds) const {
    const std::int64_t at = layer_of(seconds);
    const auto passes = [&](const LeftOut& stretch) { return stretch.begin < seconds && seconds < stretch.end; };
    return passes(layer(at).longest) || (at + 1 < layers() && passes(layer(at + 1).longest));
}

double Volume::t_of_seconds(double seconds) const {
    const std::int64_t low = layer_of(seconds);
    const Layer& at = layer(low);
    const auto frames = static_cast<double>(at.frames);
    // The clip's last layer's own frames tell how long it lasts, else the next layer's beginning.
    double length = low + 1 < layers() && layer(low + 1).left_out == 0 ? layer(low + 1).pts - at.pts : 0;
    if (length <= 0 && at.frames > 1) length = (at.last_pts - at.pts) * frames / (frames - 1);
    const double share = length > 0 ? std::clamp((seconds - at.pts) / length, 0.0, 1.0) : 0.5;
    return t_end() * (static_cast<double>(low) + share) / static_cast<double>(layers());
}

glm::dvec3 Volume::c_of(const glm::dvec3& point) const {
    return {1 - (point.x + 0.5) / size_.width, 1 - (point.y + 0.5) / size_.height, t_of_frame(point.z)};
}

glm::dvec3 Volume::c_vector(const glm::dvec3& vector) const {
    return {-vector.x / size_.width, -vector.y / size_.height, vector.z / static_cast<double>(span() * step_)};
}

bool Volume::seeded(std::int64_t frame) const {
    return std::ranges::binary_search(seeded_, frame, {}, &SeededFrame::frame);
}

void Volume::drop_front(std::int64_t layers) {
    const auto end = layers_.begin() + static_cast<std::ptrdiff_t>(std::min(layers, this->layers()));
    std::int64_t frames = 0;
    for (auto layer = layers_.begin(); layer != end; ++layer) frames += layer->frames;
    layers_.erase(layers_.begin(), end);
    frames_ -= frames;
    std::erase_if(seeds_, [frames](const FrameSeed& seed) { return seed.frame < frames; });
    for (FrameSeed& seed : seeds_) seed.frame -= frames;
    std::erase_if(seeded_, [frames](const SeededFrame& seeded) { return seeded.frame < frames; });
    for (SeededFrame& seeded : seeded_) seeded.frame -= frames;
    flow_.drop_front(frames);
}

void Volume::join_pairs() {
    std::vector<Layer> joined;
    joined.reserve(layers_.size());
    for (std::size_t i = 0; i < layers_.size(); i += 2) {
        Layer layer = std::move(layers_[i]);
        if (i + 1 < layers_.size()) {
            join(values_, layer, layers_[i + 1].scalar, layers_[i + 1].colour, layers_[i + 1].owner);
            layer.frames += layers_[i + 1].frames;
            layer.missing += layers_[i + 1].missing;
            layer.last_frame = layers_[i + 1].last_frame;
            layer.last_pts = layers_[i + 1].last_pts;
            pass_over(layer, layers_[i + 1].left_out, layers_[i + 1].longest);
        }
        joined.push_back(std::move(layer));
    }
    layers_ = std::move(joined);
    step_ *= 2;
    seed_interval_ *= 2;
    // By the frame's index in the clip, as flow is: a clip that begins in the middle keeps them in step.
    std::erase_if(seeded_, [this](const SeededFrame& seeded) { return seeded.index % seed_interval_ != 0; });
    std::erase_if(seeds_, [this](const FrameSeed& seed) { return !seeded(seed.frame); });
    flow_.erase_if([this](std::int64_t frame) { return !seeded(frame); });
}

std::vector<Brick> cut_by_clock(const Volume& volume, double length, double clock) {
    const auto turn = [&](std::int64_t layer) { return std::floor((volume.layer(layer).pts + clock) / length); };
    std::vector<Brick> bricks;
    for (std::int64_t i = 0; i < volume.layers(); ++i) {
        if (bricks.empty() || turn(i) != turn(i - 1)) bricks.push_back({i, 0});
        ++bricks.back().count;
    }
    return bricks;
}

}  // namespace vvr
