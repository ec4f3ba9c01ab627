#include "core/scene/slices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace vvr::scene {

namespace {

struct SlicePolygon {
    std::uint32_t first_vertex = 0;
    std::uint32_t vertices = 0;
    int slice = 0;
};

/// The drawn part of a cell: a hexahedron in P-space.
struct Proxy {
    volume::CellBox box;  ///< in C-space; may be smaller than the cell
    std::array<glm::dvec3, 8> corners;
    std::array<double, 8> depth{};  ///< in slices from the nearest slice
    float t_reference = 0;
    bool visible = false;

    /// Intersection of a slice with an edge. Proxies that share the edge get bit-identical results.
    glm::vec3 crossing(std::size_t edge, int slice) const {
        const auto [a, b] = ends(edge);
        return glm::vec3(glm::mix(corners[a], corners[b], (slice - depth[a]) / (depth[b] - depth[a])));
    }

    bool crosses(std::size_t edge, int slice) const {
        const auto [a, b] = ends(edge);
        return (depth[a] >= slice) != (depth[b] >= slice);
    }

  private:
    static std::array<std::size_t, 2> ends(std::size_t edge) {
        return {static_cast<std::size_t>(space::hexahedron_edges[edge][0]),
                static_cast<std::size_t>(space::hexahedron_edges[edge][1])};
    }
};

/// A proxy's neighbours by face; null if no neighbour touches it.
using Neighbours = std::array<const Proxy*, 6>;

struct Corner {
    glm::vec3 p;
    int face = 0;  ///< that contains the polygon's side to the next corner
};

bool borders_on(std::size_t edge, int face) {
    return space::hexahedron_edge_faces[edge][0] == face || space::hexahedron_edge_faces[edge][1] == face;
}

int other_face(std::size_t edge, int face) {
    return space::hexahedron_edge_faces[edge][space::hexahedron_edge_faces[edge][0] == face ? 1 : 0];
}

/// Intersects a proxy with a slice. Walks from edge to edge over the faces, so the corners come in order without
/// sorting by angle.
void cut_proxy(const Proxy& proxy, int slice, std::vector<Corner>& polygon) {
    polygon.clear();
    std::array<bool, 12> crossed{};
    std::size_t edge = space::hexahedron_edges.size();
    for (std::size_t e = 0; e < space::hexahedron_edges.size(); ++e) {
        crossed[e] = proxy.crosses(e, slice);
        if (crossed[e]) edge = e;
    }
    if (edge == space::hexahedron_edges.size()) return;
    for (int face = space::hexahedron_edge_faces[edge][0];; face = other_face(edge, face)) {
        polygon.push_back({proxy.crossing(edge, slice), face});
        crossed[edge] = false;
        std::size_t next = 0;
        while (next < space::hexahedron_edges.size() && !(crossed[next] && borders_on(next, face))) ++next;
        if (next == space::hexahedron_edges.size()) return;
        edge = next;
    }
}

/// Triangulates a polygon as a fan and adds those corners of neighbouring polygons that lie on its sides. Without them,
/// T-junctions would leave pixels that are drawn twice or not at all.
void make_fan(const Neighbours& neighbours, int slice, const std::vector<Corner>& polygon,
              std::vector<glm::vec3>& fan) {
    fan.clear();
    glm::vec3 sum{0};
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner& from = polygon[i];
        const glm::vec3 side = polygon[(i + 1) % polygon.size()].p - from.p;
        sum += from.p;
        fan.push_back(from.p);
        const Proxy* beyond = neighbours[static_cast<std::size_t>(from.face)];
        if (beyond == nullptr) continue;
        std::array<float, 2> places{};
        std::array<glm::vec3, 2> points;
        std::size_t found = 0;
        for (std::size_t e = 0; e < space::hexahedron_edges.size() && found < 2; ++e) {
            if (!borders_on(e, from.face ^ 1) || !beyond->crosses(e, slice)) continue;
            const glm::vec3 point = beyond->crossing(e, slice);
            const float place = glm::dot(point - from.p, side) / glm::dot(side, side);
            if (place <= 0 || place >= 1) continue;
            points[found] = point;
            places[found++] = place;
        }
        if (found == 2 && places[0] > places[1]) std::swap(points[0], points[1]);
        fan.insert(fan.end(), points.begin(), points.begin() + static_cast<std::ptrdiff_t>(found));
    }
    if (fan.size() == polygon.size()) return;
    // A fan around a corner would skip the points on the two sides at that corner, so use the centroid.
    fan.push_back(fan.front());
    fan.insert(fan.begin(), sum / static_cast<float>(polygon.size()));
}

/// Clipping outcode: one bit for each side of the picture that the point lies beyond.
unsigned outside_of(const glm::dvec4& p) {
    return (p.x < -p.w ? 1U : 0U) | (p.x > p.w ? 2U : 0U) | (p.y < -p.w ? 4U : 0U) | (p.y > p.w ? 8U : 0U);
}

/// The context that all proxies of a picture share.
struct Cutting {
    const space::Layout* layout;
    const TransferFunction* transfer;
    const space::Camera* camera;
    const SliceStack* stack;
    glm::dmat4 clip_from_p;
    bool zero_is_empty;
};

/// The proxies of a brick between two consecutive cell borders in time.
using Slab = std::vector<Proxy>;

Proxy make_proxy(const Cutting& cutting, const volume::PlacedCells& brick, int ix, int iy, int it) {
    const volume::BrickCells& cells = *brick.cells;
    Proxy proxy;
    if (!cutting.transfer->visible(cells.range(ix, iy, it))) return proxy;
    const volume::CellBox box = cells.part(ix, iy, it, cutting.zero_is_empty);
    const auto t_at = [&](double t_b) { return std::lerp(brick.t_begin, brick.t_end, t_b); };
    const double t_low = cells.t[static_cast<std::size_t>(it)];
    const double t_high = cells.t[static_cast<std::size_t>(it) + 1];
    proxy.box = box;
    unsigned outside = ~0U;
    for (std::size_t i = 0; i < proxy.corners.size(); ++i) {
        const glm::dvec3 p =
            cutting.layout->p_from_c({(i & 1) != 0 ? box.x_high : box.x_low, (i & 2) != 0 ? box.y_high : box.y_low,
                                      t_at((i & 4) != 0 ? t_high : t_low)});
        proxy.corners[i] = p;
        proxy.depth[i] = (glm::dot(p - cutting.camera->eye, cutting.camera->forward) - cutting.stack->nearest) /
                         cutting.stack->spacing;
        outside &= outside_of(cutting.clip_from_p * glm::dvec4(p, 1));
    }
    proxy.t_reference = static_cast<float>(t_at((t_low + t_high) / 2));
    proxy.visible = outside == 0;
    return proxy;
}

Slab make_slab(const Cutting& cutting, const volume::PlacedCells& brick, int it) {
    Slab slab;
    for (int iy = 0; iy < brick.cells->ny(); ++iy) {
        for (int ix = 0; ix < brick.cells->nx(); ++ix) slab.push_back(make_proxy(cutting, brick, ix, iy, it));
    }
    return slab;
}

/// Counting sort of polygons by slice, farthest first: there are many more polygons than slices.
std::vector<SlicePolygon> farthest_first(const std::vector<SlicePolygon>& polygons, int slices) {
    std::vector<std::size_t> start(static_cast<std::size_t>(slices) + 1);
    for (const SlicePolygon& polygon : polygons) ++start[static_cast<std::size_t>(slices - 1 - polygon.slice) + 1];
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    std::vector<SlicePolygon> sorted(polygons.size());
    for (const SlicePolygon& polygon : polygons)
        sorted[start[static_cast<std::size_t>(slices - 1 - polygon.slice)]++] = polygon;
    return sorted;
}

}  // namespace

SliceStack stack_slices(const space::Camera& camera, const space::Layout& layout, int count, double spacing) {
    double low = std::numeric_limits<double>::infinity();
    double high = 0;
    for (const glm::dvec3& p : outline_points(layout)) {
        const double depth = glm::dot(p - camera.eye, camera.forward);
        low = std::min(low, depth);
        high = std::max(high, depth);
    }
    low = std::max(low, 0.0);
    SliceStack stack;
    stack.count = count > 0 ? count : std::max(1, static_cast<int>(std::ceil((high - low) / spacing)));
    stack.spacing = (high - low) / stack.count;
    stack.nearest = low + stack.spacing / 2;
    return stack;
}

SliceMesh cut_slices(std::span<const volume::PlacedCells> bricks, std::size_t number, const space::Layout& layout,
                     const TransferFunction& transfer, const space::Camera& camera, const SliceStack& stack) {
    const Cutting cutting{&layout, &transfer, &camera, &stack, camera.clip_from_p(), !transfer.visible({0, 0})};
    const volume::PlacedCells& brick = bricks[number];
    const int nx = brick.cells->nx();
    const int ny = brick.cells->ny();
    const int nt = brick.cells->nt();
    // This brick's slabs and one on either side, which may belong to the neighbouring brick.
    const auto slab_at = [&](int it) -> Slab {
        if (it >= 0 && it < nt) return make_slab(cutting, brick, it);
        const std::size_t beside = it < 0 ? number - 1 : number + 1;  // huge for the first brick's -1
        if (beside >= bricks.size() || bricks[beside].cells->nx() != nx || bricks[beside].cells->ny() != ny) return {};
        return make_slab(cutting, bricks[beside], it < 0 ? bricks[beside].cells->nt() - 1 : 0);
    };

    SliceMesh mesh;
    std::vector<SlicePolygon> polygons;
    std::vector<Corner> corners;
    std::vector<glm::vec3> fan;
    Slab before = slab_at(-1);
    Slab slab = slab_at(0);
    for (int it = 0; it < nt; ++it) {
        Slab after = slab_at(it + 1);
        const auto at = [nx](int ix, int iy) { return static_cast<std::size_t>(iy * nx + ix); };
        const auto drawn = [](const Slab& of, std::size_t i) {
            return !of.empty() && of[i].visible ? &of[i] : nullptr;
        };
        for (int iy = 0; iy < ny; ++iy) {
            for (int ix = 0; ix < nx; ++ix) {
                const Proxy& proxy = slab[at(ix, iy)];
                if (!proxy.visible) continue;
                // A box smaller than its cell doesn't touch the next one.
                const auto touching = [&](bool exists, int x, int y, double volume::CellBox::*far,
                                          double volume::CellBox::*near) {
                    const Proxy* const beside = exists ? drawn(slab, at(x, y)) : nullptr;
                    return beside != nullptr && beside->box.*far == proxy.box.*near ? beside : nullptr;
                };
                const Neighbours neighbours = {
                    touching(ix > 0, ix - 1, iy, &volume::CellBox::x_high, &volume::CellBox::x_low),
                    touching(ix + 1 < nx, ix + 1, iy, &volume::CellBox::x_low, &volume::CellBox::x_high),
                    touching(iy > 0, ix, iy - 1, &volume::CellBox::y_high, &volume::CellBox::y_low),
                    touching(iy + 1 < ny, ix, iy + 1, &volume::CellBox::y_low, &volume::CellBox::y_high),
                    drawn(before, at(ix, iy)),
                    drawn(after, at(ix, iy))};
                const auto [low, high] = std::ranges::minmax(proxy.depth);
                const int first = std::max(0, static_cast<int>(std::ceil(low)));
                const int last = std::min(stack.count - 1, static_cast<int>(std::floor(high)));
                for (int slice = first; slice <= last; ++slice) {
                    cut_proxy(proxy, slice, corners);
                    if (corners.size() < 3) continue;
                    make_fan(neighbours, slice, corners, fan);
                    polygons.push_back({static_cast<std::uint32_t>(mesh.vertices.size()),
                                        static_cast<std::uint32_t>(fan.size()), slice});
                    for (const glm::vec3& corner : fan) mesh.vertices.push_back({corner, proxy.t_reference});
                }
            }
        }
        before = std::move(slab);
        slab = std::move(after);
    }
    int slice = stack.count;
    for (const SlicePolygon& polygon : farthest_first(polygons, stack.count)) {
        if (polygon.slice != slice && !mesh.indices.empty()) mesh.slice_ends.push_back(mesh.indices.size());
        slice = polygon.slice;
        for (std::uint32_t i = 2; i < polygon.vertices; ++i) {
            mesh.indices.insert(mesh.indices.end(),
                                {polygon.first_vertex, polygon.first_vertex + i - 1, polygon.first_vertex + i});
        }
    }
    if (!mesh.indices.empty()) mesh.slice_ends.push_back(mesh.indices.size());
    return mesh;
}

std::vector<glm::dvec3> outline_points(const space::Layout& layout) {
    constexpr int steps = 64;
    std::vector<glm::dvec3> points;
    for (int i = 0; i <= steps; ++i) {
        for (int corner = 0; corner < 4; ++corner) {
            points.push_back(layout.p_from_c({corner & 1, corner >> 1, static_cast<double>(i) / steps}));
        }
    }
    return points;
}

}  // namespace vvr::scene
