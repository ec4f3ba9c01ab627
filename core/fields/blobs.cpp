#include "core/fields/blobs.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <vector>

namespace vvr {
namespace {

/// Neighbouring pixels of one row that are not 0: columns first to last - 1.
struct Run {
    int row;
    int first;
    int last;
    std::size_t parent;  ///< of the same blob; its own number for the one that stands for the blob
};

/// Difference pictures are nearly all 0, so rows are passed over eight pixels at a time.
int next_not_zero(std::span<const std::uint8_t> row, int i) {
    const int width = static_cast<int>(row.size());
    std::uint64_t eight = 0;
    while (i + 8 <= width) {
        std::memcpy(&eight, row.data() + i, 8);
        if (eight != 0) break;
        i += 8;
    }
    while (i < width && row[static_cast<std::size_t>(i)] == 0) ++i;
    return i;
}

std::vector<Run> runs_of(const Plane<std::uint8_t>& plane) {
    std::vector<Run> runs;
    for (int j = 0; j < plane.height(); ++j) {
        const std::span<const std::uint8_t> row = plane.row(j);
        int i = next_not_zero(row, 0);
        while (i < plane.width()) {
            const int first = i;
            while (i < plane.width() && row[static_cast<std::size_t>(i)] != 0) ++i;
            runs.push_back({j, first, i, runs.size()});
            i = next_not_zero(row, i);
        }
    }
    return runs;
}

std::size_t root(std::vector<Run>& runs, std::size_t k) {
    while (runs[k].parent != k) k = runs[k].parent = runs[runs[k].parent].parent;
    return k;
}

// Runs are in order of rows and columns, so two fingers find all that touch between one row and the next.
void join_neighbours(std::vector<Run>& runs) {
    std::size_t above = 0;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        while (above < k && (runs[above].row < runs[k].row - 1 ||
                             (runs[above].row == runs[k].row - 1 && runs[above].last < runs[k].first))) {
            ++above;
        }
        for (std::size_t m = above; m < k && runs[m].row == runs[k].row - 1 && runs[m].first <= runs[k].last; ++m) {
            runs[root(runs, m)].parent = root(runs, k);
        }
    }
}

}  // namespace

void remove_small_blobs(Plane<std::uint8_t>& plane, int min_area) {
    if (min_area <= 1) return;
    std::vector<Run> runs = runs_of(plane);
    join_neighbours(runs);
    std::vector<int> areas(runs.size());
    for (std::size_t k = 0; k < runs.size(); ++k) areas[root(runs, k)] += runs[k].last - runs[k].first;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        if (areas[root(runs, k)] >= min_area) continue;
        const std::span<std::uint8_t> row = plane.row(runs[k].row);
        std::fill(row.begin() + runs[k].first, row.begin() + runs[k].last, std::uint8_t{0});
    }
}

}  // namespace vvr
