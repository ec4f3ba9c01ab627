#include "core/bricks/joins.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace vvr::bricks {

namespace {

bool is_gap(const Layer& layer) {
    return layer.missing == layer.frames;
}

/// Two layers in which nothing moves: two of a gap, or none.
bool are_idle(const Layer& a, const Layer& b) {
    return is_idle(a) && is_idle(b) && is_gap(a) == is_gap(b);
}

template <class Value, class Of>
std::optional<std::size_t> least(const std::vector<Layer>& layers, const Of& value_of) {
    std::optional<std::size_t> found;
    Value least = std::numeric_limits<Value>::max();
    for (std::size_t i = 0; i + 1 < layers.size(); ++i) {
        const std::optional<Value> value = value_of(i);
        if (!value || (found && *value >= least)) continue;
        least = *value;
        found = i;
    }
    return found;
}

}  // namespace

double merge_loss(const Layer& a, const Layer& b) {
    // What lies there while nothing moves is no loss in a layer of any length.
    const std::int64_t in_a = is_idle(a) ? 0 : a.scalar.count();
    const std::int64_t in_b = is_idle(b) ? 0 : b.scalar.count();
    if (in_a == 0 && in_b == 0) return 0;
    const std::int64_t both = in_a == 0 ? in_b : in_b == 0 ? in_a : count_union(a.scalar, b.scalar);
    return static_cast<double>((a.frames + b.frames) * both - a.frames * in_a - b.frames * in_b);
}

void LayerMerger::add(const std::vector<Layer>& layers) {
    if (layers.size() > 1) losses_.push_back(merge_loss(layers[layers.size() - 2], layers.back()));
}

void LayerMerger::merge_at(std::vector<Layer>& layers, std::size_t i) {
    join(layers[i], layers[i + 1], values_);
    layers.erase(layers.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    losses_.erase(losses_.begin() + static_cast<std::ptrdiff_t>(i));
    if (i < losses_.size()) losses_[i] = merge_loss(layers[i], layers[i + 1]);
    if (i > 0) losses_[i - 1] = merge_loss(layers[i - 1], layers[i]);
}

bool LayerMerger::merge_idle(std::vector<Layer>& layers) {
    const auto found = least<std::int64_t>(layers, [&](std::size_t i) -> std::optional<std::int64_t> {
        if (!are_idle(layers[i], layers[i + 1])) return std::nullopt;
        return layers[i].frames + layers[i + 1].frames;
    });
    if (found) merge_at(layers, *found);
    return found.has_value();
}

void LayerMerger::merge_cheapest(std::vector<Layer>& layers, std::size_t idle) {
    const auto all_idle = static_cast<std::size_t>(std::ranges::count_if(layers, is_idle));
    if (all_idle > idle && merge_idle(layers)) return;
    const auto moving = least<double>(layers, [&](std::size_t i) -> std::optional<double> {
        if (is_idle(layers[i]) && is_idle(layers[i + 1])) return std::nullopt;
        return losses_[i];
    });
    if (moving) return merge_at(layers, *moving);
    if (!merge_idle(layers)) merge_at(layers, 0);
}

}  // namespace vvr::bricks
