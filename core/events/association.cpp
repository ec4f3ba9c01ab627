#include "core/events/association.h"

#include <algorithm>
#include <limits>

#include "core/events/assignment.h"

namespace vvr::events {

namespace {

constexpr double never = 10;
constexpr double like_size = 2.5;     // times by which the areas of one thing differ at most from frame to frame
constexpr double shared_part = 0.15;  // of a track that falls on a blob in which it is not alone
constexpr double wider = 1.15;        // times its usual size that an object is with its pieces

double ratio(double a, double b) {
    return std::max(a, b) / std::max(1.0, std::min(a, b));
}

double cost_of(const PredictedTrack& track, int overlap, const Patch& blob, const Appearance& look,
               const EventOptions& options) {
    const Patch& patch = *track.patch;
    const double looks = distance(*track.appearance, look);
    if (overlap > 0) {
        const double all = std::max(1, patch.area + blob.area - overlap);
        const double places = std::max(0.0, 1 - overlap / all);
        return track.was_merged ? 0.5 * places + 0.8 * looks : 0.8 * places + 0.2 * looks;
    }
    const double length = std::max(track.usual_size.x, track.usual_size.y);
    const double away = glm::distance(patch.centre + glm::dvec2(track.shift), blob.centre) / std::max(4.0, length);
    if (away > options.gate || ratio(patch.area, blob.area) > like_size) return never;
    return 0.5 + 0.25 * away / options.gate + 0.5 * looks;
}

/// Whether a blob belongs to a track that goes on in `rest`: together they are no larger than it has been.
bool is_fragment(const Patch& piece, const Patch& rest, const PredictedTrack& track) {
    const PixelBox whole = bounding_box(piece.box, rest.box);
    return whole.width() <= wider * track.usual_size.x + 2 && whole.height() <= wider * track.usual_size.y + 2;
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

Assignment associate(std::span<const PredictedTrack> tracks, const Blobs& blobs, std::span<const Appearance> looks,
                     const EventOptions& options) {
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
                cost_of(tracks[k], overlap[k][b], blobs.patches[b], looks[b], options);
        }
    }
    const std::vector<std::optional<int>> assigned = assign(costs, options.merge_cost);
    for (std::size_t k = 0; k < tracks.size(); ++k) {
        if (assigned[k]) result.tracks[static_cast<std::size_t>(*assigned[k])].push_back(k);
    }
    for (std::size_t k = 0; k < tracks.size(); ++k) {
        if (assigned[k]) continue;
        const auto most = std::ranges::max_element(overlap[k]);
        if (*most < shared_part * tracks[k].patch->area) continue;
        result.tracks[static_cast<std::size_t>(most - overlap[k].begin())].push_back(k);
    }

    // The only blob of each track that has one to itself.
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

}  // namespace vvr::events
