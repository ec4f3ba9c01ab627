#include "core/fields/blobs.h"

#include <numeric>
#include <vector>

namespace vvr::fields {
namespace {

/// A run of pixels in one row: columns first to last - 1.
struct Run {
    int row;
    int first;
    int last;
    std::size_t parent;  ///< another run of the same set; its own number for the set's root
};

/// Difference pictures are nearly all 0, so zeros are skipped eight at a time.
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

int next_zero(std::span<const std::uint8_t> row, int i) {
    const int width = static_cast<int>(row.size());
    while (i < width && row[static_cast<std::size_t>(i)] != 0) ++i;
    return i;
}

/// The runs of pixels other than 0, ordered by rows and columns.
std::vector<Run> runs_of(const Plane<std::uint8_t>& plane) {
    std::vector<Run> runs;
    for (int j = 0; j < plane.height(); ++j) {
        const std::span<const std::uint8_t> row = plane.row(j);
        int i = next_not_zero(row, 0);
        while (i < plane.width()) {
            const int end = next_zero(row, i);
            runs.push_back({j, i, end, runs.size()});
            i = next_not_zero(row, end);
        }
    }
    return runs;
}

/// The runs of zeros.
std::vector<Run> gaps_of(const Plane<std::uint8_t>& plane) {
    std::vector<Run> gaps;
    for (int j = 0; j < plane.height(); ++j) {
        const std::span<const std::uint8_t> row = plane.row(j);
        int i = next_zero(row, 0);
        while (i < plane.width()) {
            const int end = next_not_zero(row, i);
            gaps.push_back({j, i, end, gaps.size()});
            i = next_zero(row, end);
        }
    }
    return gaps;
}

std::size_t root(std::vector<Run>& runs, std::size_t k) {
    while (runs[k].parent != k) k = runs[k].parent = runs[runs[k].parent].parent;
    return k;
}

/// Merges runs that touch in neighbouring rows. Runs are ordered, so two indices find all such pairs in one pass.
/// \param slack 1 where runs that meet at a corner touch, 0 where they don't
void merge_neighbours(std::vector<Run>& runs, int slack) {
    std::size_t above = 0;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        while (above < k && (runs[above].row < runs[k].row - 1 ||
                             (runs[above].row == runs[k].row - 1 && runs[above].last + slack <= runs[k].first))) {
            ++above;
        }
        for (std::size_t m = above; m < k && runs[m].row == runs[k].row - 1 && runs[m].first < runs[k].last + slack;
             ++m) {
            runs[root(runs, m)].parent = root(runs, k);
        }
    }
}

std::vector<Run> blobs_of(const Plane<std::uint8_t>& plane) {
    std::vector<Run> runs = runs_of(plane);
    merge_neighbours(runs, 1);
    return runs;
}

/// Sets all runs of a component to `value` if `wanted` accepts the sum of `weight` over the component.
template <class Weight, class Wanted>
void paint(Plane<std::uint8_t>& plane, std::vector<Run>& runs, Weight weight, Wanted wanted, std::uint8_t value) {
    using Sum = decltype(weight(runs.front()));
    std::vector<Sum> sums(runs.size());
    for (std::size_t k = 0; k < runs.size(); ++k) sums[root(runs, k)] += weight(runs[k]);
    for (std::size_t k = 0; k < runs.size(); ++k) {
        if (!wanted(sums[root(runs, k)])) continue;
        const std::span<std::uint8_t> row = plane.row(runs[k].row);
        std::fill(row.begin() + runs[k].first, row.begin() + runs[k].last, value);
    }
}

int length(const Run& run) {
    return run.last - run.first;
}

/// The number of pixels of a blob, and of its strong pixels.
struct Pixels {
    int all = 0;
    int strong = 0;

    Pixels& operator+=(const Pixels& other) {
        all += other.all;
        strong += other.strong;
        return *this;
    }
};

/// The area of a component of zeros, and the sum of the differences in it.
struct Hole {
    std::int64_t area = 0;
    std::int64_t difference = 0;

    Hole& operator+=(const Hole& other) {
        area += other.area;
        difference += other.difference;
        return *this;
    }
};

/// Sets every blob of fewer than `min_area` pixels to 0.
void remove_small_blobs(Plane<std::uint8_t>& plane, int min_area) {
    if (min_area <= 1) return;
    std::vector<Run> runs = blobs_of(plane);
    paint(
        plane, runs, length, [&](int area) { return area < min_area; }, 0);
}

}  // namespace

void apply_hysteresis(Plane<std::uint8_t>& plane, const Plane<std::uint8_t>& strong, int least, int min_area) {
    const auto pixels_of = [&](const Run& run) {
        const std::uint8_t* const value = plane.row(run.row).data();
        const std::uint8_t* const enough = strong.row(run.row).data();
        Pixels pixels{.all = length(run), .strong = 0};
        for (int i = run.first; i < run.last; ++i) pixels.strong += value[i] >= enough[i] ? 1 : 0;
        return pixels;
    };
    std::vector<Run> runs = blobs_of(plane);
    paint(
        plane, runs, pixels_of, [&](const Pixels& p) { return p.all < min_area || p.strong < least; }, 0);
}

void restore_small_blobs(Plane<std::uint8_t>& plane, const Plane<std::uint8_t>& before, int max_area) {
    std::vector<Run> runs = blobs_of(before);
    std::vector<Pixels> sums(runs.size());
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const std::uint8_t* const row = plane.row(runs[k].row).data();
        const bool at_edge = runs[k].first == 0 || runs[k].last == plane.width() || runs[k].row == 0 ||
                             runs[k].row == plane.height() - 1;
        // A blob at the picture's edge doesn't count as small.
        Pixels pixels{.all = at_edge ? max_area + 1 : length(runs[k]), .strong = 0};
        for (int i = runs[k].first; i < runs[k].last; ++i) pixels.strong += row[i] != 0 ? 1 : 0;
        sums[root(runs, k)] += pixels;
    }
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const Pixels& blob = sums[root(runs, k)];
        if (blob.all > max_area || 2 * blob.strong < blob.all || blob.strong == blob.all) continue;
        const std::span<const std::uint8_t> from = before.row(runs[k].row);
        std::copy(from.begin() + runs[k].first, from.begin() + runs[k].last,
                  plane.row(runs[k].row).begin() + runs[k].first);
    }
}

void fill_holes(Plane<std::uint8_t>& plane, const Plane<std::uint8_t>& differences, const HoleOptions& options) {
    const auto measured = [&](const Run& gap) {
        const bool at_edge =
            gap.first == 0 || gap.last == plane.width() || gap.row == 0 || gap.row == plane.height() - 1;
        // A component is no hole if one of its runs is too long or at the picture's edge.
        if (at_edge || length(gap) > options.max_area) return Hole{.area = options.max_area + std::int64_t{1}};
        const std::uint8_t* const row = differences.row(gap.row).data();
        return Hole{.area = length(gap),
                    .difference = std::accumulate(row + gap.first, row + gap.last, std::int64_t{0})};
    };
    const auto is_wanted = [&](const Hole& hole) {
        return hole.area <= options.max_area && hole.difference >= options.least * hole.area;
    };
    std::vector<Run> gaps = gaps_of(plane);
    merge_neighbours(gaps, 0);
    paint(plane, gaps, measured, is_wanted, options.value);
}

void clean(Plane<std::uint8_t>& plane, const CleanOptions& options, const Plane<std::uint8_t>& region) {
    std::uint8_t* const pixels = plane.pixels().data();
    const std::size_t count = plane.pixels().size();
    // Plain byte arithmetic, which the compiler vectorizes.
    const auto threshold = static_cast<std::uint8_t>(options.threshold);
    const auto most = static_cast<std::uint8_t>(255 / options.gain);
    const auto gain = static_cast<std::uint8_t>(options.gain);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t value = pixels[i];
        const auto lit = static_cast<std::uint8_t>(std::min(value, most) * gain);
        const auto shown = static_cast<std::uint8_t>(value > most ? 255 : lit);
        pixels[i] = value < threshold ? std::uint8_t{0} : shown;
    }
    if (!region.empty()) {
        const std::uint8_t* const inside = region.pixels().data();
        for (std::size_t i = 0; i < count; ++i) pixels[i] = inside[i] == 0 ? std::uint8_t{0} : pixels[i];
    }
    remove_small_blobs(plane, options.min_area);
}

}  // namespace vvr::fields
