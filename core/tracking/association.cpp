#include "core/tracking/association.h"

#include <algorithm>
#include <limits>

#include "core/tracking/event_options.h"

namespace vvr::tracking {

// Each row also has a private column of cost `most`: a row that takes it gets no other column.
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
    // Rows and columns count from 1. Column 0 holds the row that is looking for a column.
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

namespace {

double cost_of(const PredictedTrack& track, int overlap, const Patch& blob, const Appearance& appearance) {
    const Patch& patch = *track.patch;
    const double difference = distance(*track.appearance, appearance);
    if (overlap > 0) {
        const double all = std::max(1, patch.area + blob.area - overlap);
        const double places = std::max(0.0, 1 - overlap / all);
        if (!track.was_merged)
            return thresholds.association.place_weight * places +
                   (1 - thresholds.association.place_weight) * difference;
        return thresholds.association.lost_place * places + thresholds.association.lost_looks * difference;
    }
    const double length = std::max(track.usual_size.x, track.usual_size.y);
    const double away =
        glm::distance(patch.centre + glm::dvec2(track.shift), blob.centre) / std::max(thresholds.least_length, length);
    if (away > thresholds.association.gate) return never;
    return thresholds.association.lost_place * (1 + away / (2 * thresholds.association.gate) + difference);
}

/// Whether `piece` is a fragment of a track that goes on in `rest`: both together are no larger than its usual size.
bool is_fragment(const Patch& piece, const Patch& rest, const PredictedTrack& track) {
    const PixelBox whole = bounding_box(piece.box, rest.box);
    return whole.width() <= thresholds.association.fragment_size * track.usual_size.x + 2 &&
           whole.height() <= thresholds.association.fragment_size * track.usual_size.y + 2;
}

}  // namespace

std::vector<int> overlaps_of(const Patch& patch, const glm::ivec2& shift, const Blobs& blobs) {
    std::vector<int> counts(blobs.patches.size());
    for_each_pixel(patch, [&](int i, int j, std::uint8_t) {
        const int x = i + shift.x;
        const int y = j + shift.y;
        if (x < 0 || x >= blobs.labels.width() || y < 0 || y >= blobs.labels.height()) return;
        if (const int label = blobs.labels.at(x, y)) ++counts[static_cast<std::size_t>(label) - 1];
    });
    return counts;
}

Assignment associate(std::span<const PredictedTrack> tracks, const Blobs& blobs,
                     std::span<const Appearance> appearances) {
    const std::size_t count = blobs.patches.size();
    Assignment result{std::vector<std::vector<std::size_t>>(count), std::vector<std::optional<std::size_t>>(count),
                      std::vector<std::optional<std::size_t>>(count)};
    if (count == 0) return result;

    std::vector<std::vector<int>> overlap;
    Plane<double> costs({static_cast<int>(count), static_cast<int>(tracks.size())}, never);
    for (std::size_t k = 0; k < tracks.size(); ++k) {
        overlap.push_back(overlaps_of(*tracks[k].patch, tracks[k].shift, blobs));
        if (std::ranges::max(overlap[k]) == 0) overlap[k] = overlaps_of(*tracks[k].patch, {}, blobs);
        for (std::size_t b = 0; b < count; ++b) {
            costs.at(static_cast<int>(b), static_cast<int>(k)) =
                cost_of(tracks[k], overlap[k][b], blobs.patches[b], appearances[b]);
        }
    }
    const std::vector<std::optional<int>> assigned = assign(costs, thresholds.association.cost);
    for (std::size_t k = 0; k < tracks.size(); ++k) {
        if (assigned[k]) result.tracks[static_cast<std::size_t>(*assigned[k])].push_back(k);
    }
    for (std::size_t k = 0; k < tracks.size(); ++k) {
        if (assigned[k]) continue;
        const auto most = std::ranges::max_element(overlap[k]);
        if (*most < thresholds.association.shared_part * tracks[k].patch->area) continue;
        result.tracks[static_cast<std::size_t>(most - overlap[k].begin())].push_back(k);
    }

    // The blob of each track that shares it with no other.
    std::vector<std::optional<std::size_t>> home(tracks.size());
    for (std::size_t b = 0; b < count; ++b) {
        if (result.tracks[b].size() == 1) home[result.tracks[b].front()] = b;
    }
    for (std::size_t b = 0; b < count; ++b) {
        if (!result.tracks[b].empty()) continue;
        int most = 0;
        for (std::size_t k = 0; k < tracks.size(); ++k) {
            if (overlap[k][b] > most) {
                most = overlap[k][b];
                result.split_from[b] = k;
            }
        }
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < tracks.size(); ++k) {
            if (!home[k] || !is_fragment(blobs.patches[b], blobs.patches[*home[k]], tracks[k])) continue;
            const double away = glm::distance(blobs.patches[b].centre, blobs.patches[*home[k]].centre);
            if (away >= nearest) continue;
            nearest = away;
            result.fragment_of[b] = k;
        }
        if (result.fragment_of[b]) result.split_from[b].reset();
    }
    return result;
}

}  // namespace vvr::tracking
