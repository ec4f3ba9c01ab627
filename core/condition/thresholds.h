#pragma once

#include <cstddef>

namespace vvr::condition {

/// The numbers by which conditions are found. A comment names the unit first, then one reason. Levels are grey levels,
/// a share is from 0 to 1.
struct Thresholds {
    // Views.
    int side = 64;               ///< pixels of the longer side at which edges are compared
    double edge = 2.8;           ///< levels per pixel; a block with weaker edges tells nothing
    double similar = 0.5;        ///< correlation from which on two blocks have similar edges …
    double same = 0.8;           ///< … and the same
    double edged = 0.25;         ///< share of all blocks that have edges, at least; with fewer, nothing is known either
    int fewest_blocks = 4;       ///< blocks with edges; with fewer, nothing is known of the view
    double seen = 0.5;           ///< share of the blocks with similar edges, at least, if the camera shows the view …
    double seen_exactly = 0.12;  ///< … or of those with the same: somebody may be close to the camera
    double known = 1;            ///< seconds between two frames that are kept as known
    double covered = 0.4;        ///< ratio of contrast; with less, edges are covered or too dark to be seen
    double flat = 0.6;           ///< share of the pixels within three levels: a single colour, perhaps with a text
    std::size_t fewest_of_view = 3;  ///< frames of a view, at least, that make an empty scene

    // Light.
    double other_light = 1.0 / 3;  ///< share of the picture in another light than the scene, from which on it is said …
    double passing = 60;           ///< … for so many seconds, at most: what lasts longer is the day …
    double flash = 1;              ///< … or for so many, at least
    double jump = 32;  ///< levels by which middle grey changes within a second, if all is in another light; in footage
                       ///< without that, 23 at most

    // Frozen pictures. Differences are means over two consecutive pictures.
    double equal = 0.01;  ///< levels; in footage, pictures that differ less follow each other for a second at most
    double frozen = 2;    ///< seconds for which they do, at least (FFmpeg's freezedetect)
    int strip = 16;       ///< samples in which noise is looked for
    int changes = 4;      ///< of 64 differences, in which a strip with noise changes, at least …
    double noisy = 0.8;   ///< … and share of the strips that do: in footage 0.96 to 1, in drawn pictures up to 0.5
    int fewest = 16;      ///< differences that tell what is usual …
    std::size_t usual = 512;  ///< … and how many are kept
    double settled = 0.5;  ///< ratio to the usual difference; with less, a codec may still settle on a frozen picture …
    double settling = 2;  ///< … which lasts so many seconds, at most
};

inline constexpr Thresholds thresholds{};

}  // namespace vvr::condition
