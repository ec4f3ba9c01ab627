#pragma once

#include <array>

namespace vvr::space {

/// The corners at both ends of each edge of a hexahedron. Corner i lies at the upper end along the first, second, third
/// axis where bit 0, 1, 2 of i is set.
inline constexpr std::array<std::array<int, 2>, 12> hexahedron_edges = {
    {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

/// The two faces that each of these edges borders on. Faces 0 to 5: the low and the high end of the first, second,
/// third axis.
inline constexpr std::array<std::array<int, 2>, 12> hexahedron_edge_faces = {
    {{2, 4}, {3, 4}, {2, 5}, {3, 5}, {0, 4}, {1, 4}, {0, 5}, {1, 5}, {0, 2}, {1, 2}, {0, 3}, {1, 3}}};

}  // namespace vvr::space
