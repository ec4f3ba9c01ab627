#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/base/plane.h"
#include "core/fields/planes.h"
#include "core/media/frame.h"

// The empty scene, made of frames in which objects come and go.
namespace vvr::fields {

/// For each column, the largest value that at least `needed` of the rows reach: of n rows, (n + 1) / 2 gives the
/// median.
void rank_rows(std::span<const std::uint8_t* const> rows, std::size_t needed, std::span<std::uint8_t> result);

/// The median of each pixel and channel over frames: the upper of the two middle values for an even number. All frames
/// must have the same size; without frames the result is empty.
Planes median_reference(std::span<const media::Frame> frames);

/// The empty scene of frames that are ordered by time. Each pixel is the median of the first level that lasts for at
/// least a quarter of the frames, or else the median of all frames. Passers-by seldom stay that long. A bag left behind
/// stays an object even if it lies there for most of the clip; the median of all frames would contain it.
Planes lasting_reference(std::span<const media::Frame> frames);

/// The boxes of people, vehicles and animals in a frame, field pixels.
using LivingFinder = std::function<std::vector<PixelBox>(const media::Frame&)>;

/// Replaces people, vehicles and animals in the empty scene by what is behind them. Looks at the first frame, and only
/// if somebody is in it, at about ten more. Whoever is at a place in nearly all of them stays in the scene.
/// \param frames from which `scene` was made, in order of time
void look_behind(std::span<const media::Frame> frames, const LivingFinder& find_living, Planes& scene);

/// The usual deviation of each pixel from the empty scene, grey levels: camera noise, and more where leaves sway or
/// edges tremble. It is roughly the median deviation, taken from the quarter of the frames that deviate least (from the
/// third if the camera shakes), so that an object that is present most of the time doesn't count; from fewer frames
/// where an object stays even longer.
/// \param frames under the same light and, if the camera shakes, aligned
/// \param scene the empty scene, smoothed by `smooth` as the frames will be
/// \returns empty if there are too few frames
Plane<std::uint8_t> noise_of(std::span<const media::Frame> frames, const Planes& scene, double smooth,
                             bool shakes = false);

}  // namespace vvr::fields
