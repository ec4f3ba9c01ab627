#include "core/volume/layer.h"

#include <algorithm>
#include <limits>
#include <optional>

#include <glm/gtc/packing.hpp>

namespace vvr::volume {

template <class T>
Sparse<T>::Sparse(Size size)
    : size_(size),
      across_((size.width + fields::tile_side - 1) / fields::tile_side),
      held_(static_cast<std::size_t>(across_) *
                static_cast<std::size_t>((size.height + fields::tile_side - 1) / fields::tile_side),
            none) {}

template <>
SparsePlane::Sparse(const Plane<std::uint8_t>& whole) : Sparse(whole.size()) {
    const Plane<std::uint8_t> occupied = fields::occupied_tiles(whole);
    tiles_.reserve(static_cast<std::size_t>(std::ranges::count(occupied.pixels(), std::uint8_t{1})));
    for (std::size_t place = 0; place < held_.size(); ++place) {
        if (occupied.pixels()[place] == 0) continue;
        held_[place] = static_cast<std::int32_t>(tiles_.size());
        const PixelBox box = box_of(place);
        auto into = tiles_.emplace_back().begin();
        for (int row = box.top; row < box.bottom; ++row, into += fields::tile_side) {
            std::ranges::copy_n(whole.row(row).begin() + box.left, box.width(), into);
        }
    }
}

template <class T>
PixelBox Sparse<T>::box_of(std::size_t place) const {
    const int left = static_cast<int>(place) % across_ * fields::tile_side;
    const int top = static_cast<int>(place) / across_ * fields::tile_side;
    return {left, top, std::min(left + fields::tile_side, size_.width),
            std::min(top + fields::tile_side, size_.height)};
}

template <class T>
void Sparse<T>::set(int i, int j, T value) {
    std::int32_t& held = held_[tile_index(i, j)];
    if (held == none) {
        if (value == T{}) return;
        held = static_cast<std::int32_t>(tiles_.size());
        tiles_.emplace_back();
    }
    tiles_[static_cast<std::size_t>(held)][within(i, j)] = value;
}

template <class T>
T Sparse<T>::greatest() const {
    T greatest = 0;
    for (const Tile& tile : tiles_) greatest = std::max(greatest, std::ranges::max(tile));
    return greatest;
}

template <class T>
std::int64_t Sparse<T>::count() const {
    std::int64_t count = 0;
    for (const Tile& tile : tiles_) count += std::ssize(tile) - std::ranges::count(tile, T{});
    return count;
}

template <class T>
std::int64_t count_union(const Sparse<T>& a, const Sparse<T>& b) {
    std::int64_t count = a.count() + b.count();
    for (std::size_t place = 0; place < a.held_.size(); ++place) {
        const auto* const in_a = a.tile_at(place);
        const auto* const in_b = b.tile_at(place);
        if (in_a == nullptr || in_b == nullptr) continue;
        for (std::size_t i = 0; i < in_a->size(); ++i) count -= ((*in_a)[i] != 0 && (*in_b)[i] != 0) ? 1 : 0;
    }
    return count;
}

template <class T>
PixelBox Sparse<T>::box() const {
    PixelBox box;
    for (std::size_t place = 0; place < held_.size(); ++place) {
        if (held_[place] != none) box = bounding_box(box, box_of(place));
    }
    return box;
}

template <class T>
void Sparse<T>::reserve_for(const Sparse& other) {
    std::size_t added_tiles = 0;
    for (std::size_t place = 0; place < held_.size(); ++place) {
        if (held_[place] == none && other.held_[place] != none) ++added_tiles;
    }
    tiles_.reserve(tiles_.size() + added_tiles);
}

template <class T>
void Sparse<T>::keep_maximum(const Sparse& other) {
    reserve_for(other);
    for (std::size_t place = 0; place < held_.size(); ++place) {
        const Tile* const added = other.tile_at(place);
        if (added == nullptr) continue;
        if (held_[place] == none) {
            held_[place] = static_cast<std::int32_t>(tiles_.size());
            tiles_.push_back(*added);
        } else {
            Tile& kept = tiles_[static_cast<std::size_t>(held_[place])];
            std::ranges::transform(kept, *added, kept.begin(), std::ranges::max);
        }
    }
}

template <class T>
bool operator==(const Sparse<T>& a, const Sparse<T>& b) {
    if (a.size_ != b.size_) return false;
    for (std::size_t place = 0; place < a.held_.size(); ++place) {
        const auto* const in_a = a.tile_at(place);
        const auto* const in_b = b.tile_at(place);
        if ((in_a == nullptr) != (in_b == nullptr) || (in_a != nullptr && *in_a != *in_b)) return false;
    }
    return true;
}

template class Sparse<std::uint8_t>;
template class Sparse<std::uint16_t>;
template std::int64_t count_union(const SparsePlane& a, const SparsePlane& b);
template bool operator==(const SparsePlane& a, const SparsePlane& b);
template bool operator==(const OwnerPlane& a, const OwnerPlane& b);

namespace {

/// Merges two planes pixel by pixel where either is non-zero.
SparsePlane merged_planes(fields::Values values, const SparsePlane& before, const SparsePlane& after) {
    SparsePlane result(before.size());
    const auto visit = [&](const SparsePlane& plane) {
        plane.for_each_run([&](int column, int row, std::span<const std::uint8_t> run) {
            for (std::size_t i = 0; i < run.size(); ++i, ++column) {
                result.set(column, row, fields::joined(values, before.at(column, row), after.at(column, row)));
            }
        });
    };
    visit(before);
    visit(after);
    return result;
}

}  // namespace

void merge(Layer& layer, const Layer& next, fields::Values values) {
    if (!next.colour.empty() || !next.owner.empty()) {
        if (!next.owner.empty()) layer.owner.reserve_for(next.owner);
        next.scalar.for_each_run([&](int column, int row, std::span<const std::uint8_t> run) {
            for (const std::uint8_t value : run) {
                if (value > layer.scalar.at(column, row)) {
                    if (!next.colour.empty()) layer.colour.at(column, row) = next.colour.at(column, row);
                    if (!next.owner.empty()) layer.owner.set(column, row, next.owner.at(column, row));
                }
                ++column;
            }
        });
    }
    if (values == fields::Values::strength) {
        layer.scalar.keep_maximum(next.scalar);
    } else {
        layer.scalar = merged_planes(values, layer.scalar, next.scalar);
    }
    layer.frames += next.frames;
    layer.missing += next.missing;
    layer.moving += next.moving;
    layer.last_frame = next.last_frame;
    layer.last_pts = next.last_pts;
}

namespace {

bool is_gap(const Layer& layer) {
    return layer.missing == layer.frames;
}

/// Whether both layers have no motion, and both or neither are gaps.
bool are_idle(const Layer& a, const Layer& b) {
    return is_idle(a) && is_idle(b) && is_gap(a) == is_gap(b);
}

template <class Value, class Of>
std::optional<std::size_t> least(std::size_t layers, const Of& value_of) {
    std::optional<std::size_t> found;
    Value least = std::numeric_limits<Value>::max();
    for (std::size_t i = 0; i + 1 < layers; ++i) {
        const std::optional<Value> value = value_of(i);
        if (!value || (found && *value >= least)) continue;
        least = *value;
        found = i;
    }
    return found;
}

/// The loss of merging two neighbouring layers, in pixels times frames. A layer of n frames that has u non-zero pixels
/// shows n·u. The loss is how much more the merged layer shows than the two layers. It is 0 if nothing moves.
double merge_loss(const Layer& a, const Layer& b) {
    // Without motion, stationary pixels are no loss in a layer of any length.
    const std::int64_t in_a = is_idle(a) ? 0 : a.scalar.count();
    const std::int64_t in_b = is_idle(b) ? 0 : b.scalar.count();
    if (in_a == 0 && in_b == 0) return 0;
    const std::int64_t both = in_a == 0 ? in_b : in_b == 0 ? in_a : count_union(a.scalar, b.scalar);
    return static_cast<double>((a.frames + b.frames) * both - a.frames * in_a - b.frames * in_b);
}

}  // namespace

void LayerMerger::add(const std::vector<Layer>& layers) {
    if (layers.size() > 1) losses_.push_back(merge_loss(layers[layers.size() - 2], layers.back()));
}

void LayerMerger::restart(const std::vector<Layer>& layers) {
    losses_.clear();
    for (std::size_t i = 1; i < layers.size(); ++i) losses_.push_back(merge_loss(layers[i - 1], layers[i]));
}

void LayerMerger::merge_at(std::vector<Layer>& layers, std::size_t i) {
    merge(layers[i], layers[i + 1], values_);
    layers.erase(layers.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    losses_.erase(losses_.begin() + static_cast<std::ptrdiff_t>(i));
    if (i < losses_.size()) losses_[i] = merge_loss(layers[i], layers[i + 1]);
    if (i > 0) losses_[i - 1] = merge_loss(layers[i - 1], layers[i]);
}

bool LayerMerger::merge_idle(std::vector<Layer>& layers, std::size_t decided) {
    const auto found = least<std::int64_t>(decided, [&](std::size_t i) -> std::optional<std::int64_t> {
        if (!are_idle(layers[i], layers[i + 1])) return std::nullopt;
        return layers[i].frames + layers[i + 1].frames;
    });
    if (found) merge_at(layers, *found);
    return found.has_value();
}

void LayerMerger::merge_cheapest(std::vector<Layer>& layers, std::size_t idle, std::size_t decided) {
    const std::span known(layers.data(), decided);
    const auto all_idle = static_cast<std::size_t>(std::ranges::count_if(known, is_idle));
    if (all_idle > idle && merge_idle(layers, decided)) return;
    const auto moving = least<double>(layers.size(), [&](std::size_t i) -> std::optional<double> {
        if (is_idle(layers[i]) && is_idle(layers[i + 1])) return std::nullopt;
        // A layer of both would show a gap as time in which nothing moved.
        if (is_gap(layers[i]) != is_gap(layers[i + 1])) return std::nullopt;
        return losses_[i];
    });
    if (moving) return merge_at(layers, *moving);
    if (!merge_idle(layers, layers.size())) merge_at(layers, 0);
}

namespace {

/// The pixels on both sides of a coordinate, and its fractional position between them.
struct Between {
    Between(double at, int count) {
        const double inside = std::clamp(at, 0.0, count - 1.0);
        low = std::min(static_cast<int>(inside), count - 1);
        high = std::min(low + 1, count - 1);
        share = inside - low;
    }

    int low;
    int high;
    double share;
};

glm::dvec2 in_plane(const Plane<std::uint32_t>& packed, double column, double row) {
    const Between x(column, packed.width());
    const Between y(row, packed.height());
    const auto flow = [&packed](int i, int j) { return glm::dvec2(glm::unpackHalf2x16(packed.at(i, j))); };
    return glm::mix(glm::mix(flow(x.low, y.low), flow(x.high, y.low), x.share),
                    glm::mix(flow(x.low, y.high), flow(x.high, y.high), x.share), y.share);
}

}  // namespace

void FlowVolume::add(std::int64_t frame, const fields::Flow& flow) {
    Layer layer{frame, Plane<std::uint32_t>::for_overwrite(flow.u.size())};
    std::ranges::transform(flow.u.pixels(), flow.v.pixels(), layer.packed.pixels().begin(), [](float u, float v) {
        return glm::packHalf2x16({u, v});
    });
    layers_.push_back(std::move(layer));
}

void FlowVolume::erase_if(const std::function<bool(std::int64_t)>& gone) {
    std::erase_if(layers_, [&gone](const Layer& layer) { return gone(layer.frame); });
}

void FlowVolume::drop_front(std::int64_t frame) {
    erase_if([frame](std::int64_t kept) { return kept < frame; });
    for (Layer& layer : layers_) layer.frame -= frame;
}

std::size_t FlowVolume::bytes() const {
    std::size_t bytes = 0;
    for (const Layer& layer : layers_) bytes += layer.packed.pixels().size_bytes();
    return bytes;
}

glm::dvec2 FlowVolume::at(const glm::dvec3& point) const {
    if (layers_.empty()) return {0, 0};
    const auto after = std::ranges::upper_bound(layers_, point.z, {},
                                                [](const Layer& layer) { return static_cast<double>(layer.frame); });
    if (after == layers_.begin()) return in_plane(after->packed, point.x, point.y);
    const Layer& low = *(after - 1);
    const glm::dvec2 flow = in_plane(low.packed, point.x, point.y);
    const double share = point.z - static_cast<double>(low.frame);
    // Exactly on a stored frame, the next one has no weight. Traces without v_t stay on such frames.
    if (after == layers_.end() || share == 0) return flow;
    return glm::mix(flow, in_plane(after->packed, point.x, point.y),
                    share / static_cast<double>(after->frame - low.frame));
}

}  // namespace vvr::volume
