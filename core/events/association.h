#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/plane.h"
#include "core/events/appearance.h"
#include "core/events/patch.h"

namespace vvr::events {

/// A cost that nothing is worth.
inline constexpr double never = 10;

/// Gives each row at most one column, so that the sum of the costs is the least that there is (the Hungarian method
/// with potentials, after Kuhn and Munkres: O(rows² · columns)).
/// \param costs a row's cost for each column; `most` or more means never
/// \returns the column of each row
std::vector<std::optional<int>> assign(const Plane<double>& costs, double most);

/// A track, where it should be by now.
struct PredictedTrack {
    const Patch* patch = nullptr;  ///< as it was last seen
    glm::ivec2 shift{};            ///< to where motion leads
    const Appearance* appearance = nullptr;
    bool was_merged = false;  ///< it shared a blob with others, so that looks count more than places
    glm::dvec2 usual_size{};  ///< width and height of late, field pixels
};

/// Which tracks go on in which blobs.
struct Assignment {
    std::vector<std::vector<std::size_t>> tracks;         ///< of each blob; two or more have merged there
    std::vector<std::optional<std::size_t>> fragment_of;  ///< of each blob without tracks: whose piece it is
    std::vector<std::optional<std::size_t>> split_from;   ///< of each other blob without tracks: out of whom it came
};

/// How many pixels of a shifted patch fall on each blob.
std::vector<int> overlaps_of(const Patch& patch, const glm::ivec2& shift, const Blobs& blobs);

/// Finds the blobs in which tracks go on: one each, by overlap, distance and looks, the best for all of them together.
/// Who gets none shares the blob that it falls on. A blob that nobody took is a piece of the track that it lies in, or
/// something new.
/// \param looks of the blobs
Assignment associate(std::span<const PredictedTrack> tracks, const Blobs& blobs, std::span<const Appearance> looks);

}  // namespace vvr::events
