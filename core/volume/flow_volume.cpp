#include "core/volume/flow_volume.h"

#include <algorithm>

#include <glm/gtc/packing.hpp>

namespace vvr::volume {

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
