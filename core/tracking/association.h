#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/plane.h"
#include "core/tracking/appearance.h"
#include "core/tracking/patch.h"

namespace vvr::tracking {

/// The cost of an impossible assignment, above every limit of costs.
inline constexpr double never = 10;

/// Gives each row at most one column so that the sum of costs is least (Hungarian method with potentials, after Kuhn
/// and Munkres; O(rows² · columns)).
/// \param costs the cost of each column (x) for each row (y); `most` or more excludes the pair
/// \returns the column of each row; nothing where a row gets none
std::vector<std::optional<int>> assign(const Plane<double>& costs, double most);

/// A track and its predicted place.
struct PredictedTrack {
    const Patch* patch = nullptr;  ///< in its last field
    glm::ivec2 shift{};            ///< from there to the predicted place
    const Appearance* appearance = nullptr;
    bool was_merged = false;  ///< it shared a blob with others: looks then count more than places
    glm::dvec2 usual_size{};  ///< usual width and height, field pixels
};

/// The result of data association. The outer index of each list is that of the blob; tracks are indices too.
struct Assignment {
    std::vector<std::vector<std::size_t>> tracks;         ///< two or more have merged in the blob
    std::vector<std::optional<std::size_t>> fragment_of;  ///< without tracks: it is a fragment of this track
    std::vector<std::optional<std::size_t>> split_from;   ///< else: it has split from this track
};

/// The number of pixels of the shifted patch that lie on each blob.
std::vector<int> overlaps_of(const Patch& patch, const glm::ivec2& shift, const Blobs& blobs);

/// Assigns blobs to tracks. Each track gets one blob, by overlap, distance and looks, so that the sum of costs is
/// least. A track without a blob of its own shares the one that it overlaps most: they merge. A blob without tracks is
/// a fragment of a track, has split from one, or is new.
/// \param appearances one per blob
Assignment associate(std::span<const PredictedTrack> tracks, const Blobs& blobs,
                     std::span<const Appearance> appearances);

}  // namespace vvr::tracking
