#include "core/events/assignment.h"

#include <algorithm>
#include <limits>

namespace vvr::events {

// Each row may also take a private column of cost `most`: then it stays without one.
std::vector<std::optional<int>> assign(const Plane<double>& costs, double most) {
    const int rows = costs.height();
    const int columns = costs.width();
    const int all = columns + rows;
    const auto cost = [&](int row, int column) {
        if (column < columns) return std::min(costs.at(column, row), 2 * most);
        return column - columns == row ? most : 2 * most;
    };
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    // Rows and columns count from 1; 0 is the row that looks for a column.
    std::vector<double> row_potential(at(rows + 1));
    std::vector<double> column_potential(at(all + 1));
    std::vector<int> row_of(at(all + 1));
    std::vector<int> way(at(all + 1));
    for (int row = 1; row <= rows; ++row) {
        row_of[0] = row;
        int column = 0;
        std::vector<double> least(at(all + 1), infinity);
        std::vector<bool> used(at(all + 1));
        do {
            used[at(column)] = true;
            const int here = row_of[at(column)];
            double delta = infinity;
            int next = 0;
            for (int j = 1; j <= all; ++j) {
                if (used[at(j)]) continue;
                const double reduced = cost(here - 1, j - 1) - row_potential[at(here)] - column_potential[at(j)];
                if (reduced < least[at(j)]) {
                    least[at(j)] = reduced;
                    way[at(j)] = column;
                }
                if (least[at(j)] < delta) {
                    delta = least[at(j)];
                    next = j;
                }
            }
            for (int j = 0; j <= all; ++j) {
                if (used[at(j)]) {
                    row_potential[at(row_of[at(j)])] += delta;
                    column_potential[at(j)] -= delta;
                } else {
                    least[at(j)] -= delta;
                }
            }
            column = next;
        } while (row_of[at(column)] != 0);
        for (; column != 0; column = way[at(column)]) row_of[at(column)] = row_of[at(way[at(column)])];
    }
    std::vector<std::optional<int>> result(at(rows));
    for (int j = 1; j <= columns; ++j) {
        const int row = row_of[at(j)];
        if (row != 0 && costs.at(j - 1, row - 1) < most) result[at(row - 1)] = j - 1;
    }
    return result;
}

}  // namespace vvr::events
