#include "core/scene/slices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vvr {

namespace {

// Corner i of a cell lies at the upper border in x, y, t where bit 0, 1, 2 of i is set.
constexpr std::array<std::array<int, 2>, 12> edges = {{
    {0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7},
}};

// The edges around each corner's neighbours by face: which faces (x low, x high, y low …) an edge borders on.
constexpr std::array<std::array<int, 2>, 12> faces_of_edge = {{
    {2, 4}, {3, 4}, {2, 5}, {3, 5}, {0, 4}, {1, 4}, {0, 5}, {1, 5}, {0, 2}, {1, 2}, {0, 3}, {1, 3},
}};

struct Piece {
    std::uint32_t first_vertex = 0;
    std::uint32_t vertices = 0;
    int slice = 0;
};

struct Cell {
    std::array<glm::dvec3, 8> corners;
    std::array<double, 8> depth;  ///< in slices from the nearest slice
    float t_reference = 0;
};

/// The polygon in which slice `slice` meets the cell, its corners in order around it. Walks from edge to edge over the
/// faces, so no sorting by angle is needed and neighbours get bit for bit the same corners on a shared edge.
int cut_cell(const Cell& cell, int slice, std::array<glm::vec3, 6>& polygon) {
    std::array<bool, 12> crossed{};
    int start = -1;
    for (int e = 0; e < 12; ++e) {
        const auto [a, b] = edges[static_cast<std::size_t>(e)];
        const bool above_a = cell.depth[static_cast<std::size_t>(a)] >= slice;
        const bool above_b = cell.depth[static_cast<std::size_t>(b)] >= slice;
        crossed[static_cast<std::size_t>(e)] = above_a != above_b;
        if (above_a != above_b) start = e;
    }
    if (start < 0) return 0;

    int corners = 0;
    int edge = start;
    int face = faces_of_edge[static_cast<std::size_t>(start)][0];
    do {
        const auto [a, b] = edges[static_cast<std::size_t>(edge)];
        const double depth_a = cell.depth[static_cast<std::size_t>(a)];
        const double depth_b = cell.depth[static_cast<std::size_t>(b)];
        const double share = (slice - depth_a) / (depth_b - depth_a);
        polygon[static_cast<std::size_t>(corners++)] =
            glm::vec3(glm::mix(cell.corners[static_cast<std::size_t>(a)], cell.corners[static_cast<std::size_t>(b)], share));
        crossed[static_cast<std::size_t>(edge)] = false;
        int next = -1;
        for (int e = 0; e < 12 && next < 0; ++e) {
            const auto& faces = faces_of_edge[static_cast<std::size_t>(e)];
            if (crossed[static_cast<std::size_t>(e)] && (faces[0] == face || faces[1] == face)) next = e;
        }
        if (next < 0) break;
        const auto& faces = faces_of_edge[static_cast<std::size_t>(next)];
        face = faces[0] == face ? faces[1] : faces[0];
        edge = next;
    } while (corners < 6);
    return corners;
}

/// One bit for each side of the picture that a point of clip space lies beyond.
unsigned outside_of(const glm::dvec4& p) {
    return (p.x < -p.w ? 1U : 0U) | (p.x > p.w ? 2U : 0U) | (p.y < -p.w ? 4U : 0U) | (p.y > p.w ? 8U : 0U);
}

/// The borders of cells in P-space and in slices, computed once for all the cells that share them.
struct Lattice {
    Lattice(const PlacedBrick& brick, const Layout& layout, const Camera& camera, const SliceStack& stack)
        : nx(brick.cells->x.size()), ny(brick.cells->y.size()) {
        const BrickCells& cells = *brick.cells;
        const glm::dmat4 clip_from_p = camera.clip_from_p();
        const double bulge = layout.sagitta_x((brick.t_end - brick.t_begin) / cells.nt());
        for (const double t_b : cells.t) {
            const double t = std::lerp(brick.t_begin, brick.t_end, t_b);
            for (const double y : cells.y) {
                for (const double x : cells.x) {
                    // Flat outer faces would cut the curved volume short; the fragment shader rejects what is too much.
                    const glm::dvec3 p = layout.p_from_c({x == cells.x.back() ? x * (1 + 2 * bulge) : x, y, t});
                    points.push_back(p);
                    depths.push_back((glm::dot(p - camera.eye, camera.forward) - stack.nearest) / stack.spacing);
                    outside.push_back(outside_of(clip_from_p * glm::dvec4(p, 1)));
                }
            }
        }
    }

    std::size_t at(int ix, int iy, int it) const {
        return (static_cast<std::size_t>(it) * ny + static_cast<std::size_t>(iy)) * nx + static_cast<std::size_t>(ix);
    }

    std::size_t nx;
    std::size_t ny;
    std::vector<glm::dvec3> points;
    std::vector<double> depths;
    std::vector<unsigned> outside;
};

/// Orders pieces by slice, the farthest first, by counting: there are many more pieces than slices.
std::vector<Piece> farthest_first(const std::vector<Piece>& pieces, int slices) {
    std::vector<std::size_t> start(static_cast<std::size_t>(slices) + 1);
    for (const Piece& piece : pieces) ++start[static_cast<std::size_t>(slices - 1 - piece.slice) + 1];
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    std::vector<Piece> sorted(pieces.size());
    for (const Piece& piece : pieces) sorted[start[static_cast<std::size_t>(slices - 1 - piece.slice)]++] = piece;
    return sorted;
}

}  // namespace

SliceStack stack_slices(const Camera& camera, const Layout& layout, int count, double spacing) {
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

SliceMesh cut_slices(const PlacedBrick& brick, const Layout& layout, const TransferFunction& transfer,
                     const Camera& camera, const SliceStack& stack) {
    const BrickCells& cells = *brick.cells;
    const Lattice lattice(brick, layout, camera, stack);
    SliceMesh mesh;
    std::vector<Piece> pieces;
    std::array<glm::vec3, 6> polygon;
    for (int it = 0; it < cells.nt(); ++it) {
        for (int iy = 0; iy < cells.ny(); ++iy) {
            for (int ix = 0; ix < cells.nx(); ++ix) {
                if (!transfer.visible(cells.range(ix, iy, it))) continue;
                Cell cell;
                unsigned outside = ~0U;
                for (int corner = 0; corner < 8; ++corner) {
                    const std::size_t at = lattice.at(ix + (corner & 1), iy + (corner >> 1 & 1), it + (corner >> 2));
                    cell.corners[static_cast<std::size_t>(corner)] = lattice.points[at];
                    cell.depth[static_cast<std::size_t>(corner)] = lattice.depths[at];
                    outside &= lattice.outside[at];
                }
                if (outside != 0) continue;
                const double t_b = (cells.t[static_cast<std::size_t>(it)] + cells.t[static_cast<std::size_t>(it) + 1]) / 2;
                cell.t_reference = static_cast<float>(std::lerp(brick.t_begin, brick.t_end, t_b));
                const auto [low, high] = std::ranges::minmax(cell.depth);
                const int first = std::max(0, static_cast<int>(std::ceil(low)));
                const int last = std::min(stack.count - 1, static_cast<int>(std::floor(high)));
                for (int slice = first; slice <= last; ++slice) {
                    const int corners = cut_cell(cell, slice, polygon);
                    if (corners < 3) continue;
                    pieces.push_back({static_cast<std::uint32_t>(mesh.vertices.size()),
                                      static_cast<std::uint32_t>(corners), slice});
                    for (int i = 0; i < corners; ++i) {
                        mesh.vertices.push_back({polygon[static_cast<std::size_t>(i)], cell.t_reference});
                    }
                }
            }
        }
    }
    int slice = stack.count;
    for (const Piece& piece : farthest_first(pieces, stack.count)) {
        if (piece.slice != slice && !mesh.indices.empty()) mesh.slice_ends.push_back(mesh.indices.size());
        slice = piece.slice;
        for (std::uint32_t i = 2; i < piece.vertices; ++i) {
            mesh.indices.insert(mesh.indices.end(),
                                {piece.first_vertex, piece.first_vertex + i - 1, piece.first_vertex + i});
        }
    }
    if (!mesh.indices.empty()) mesh.slice_ends.push_back(mesh.indices.size());
    return mesh;
}

std::vector<glm::dvec3> outline_points(const Layout& layout) {
    constexpr int steps = 64;
    std::vector<glm::dvec3> points;
    for (int i = 0; i <= steps; ++i) {
        for (int corner = 0; corner < 4; ++corner) {
            points.push_back(layout.p_from_c({corner & 1, corner >> 1, static_cast<double>(i) / steps}));
        }
    }
    return points;
}

}  // namespace vvr
