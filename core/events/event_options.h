#pragma once

namespace vvr::events {

/// What counts as an event, and how far apart two sightings of one object may be. Seconds are those of the clip; the
/// unit of a distance is the object's own length, so that one set of numbers serves near and far.
struct EventOptions {
    bool scene_is_learnt = true;  ///< the empty scene is of the clip's own frames: what all of them show belongs to it

    // What is an event.
    double stay = 2;               ///< seconds; who keeps a place for less has only slowed down
    double least = 0.8;            ///< seconds; what is seen for less is a blink of the light or a piece of something
    double least_inside = 2;       ///< seconds; the same of what neither comes in nor goes out at the picture's border
    double least_fragment = 5;     ///< seconds; and of such that came out of another: a part of it, mostly
    double own_lengths = 1.25;     ///< what goes less far than this flutters at its place, as a flag does
    double seen_part = 0.5;        ///< share of its frames in which a mover is seen; foliage comes and goes
    double steady_way = 0.25;      ///< cosine between steps half a second apart: leaves and rain turn back and forth
    double continuous = 0.75;      ///< share of a mover's sightings without a jump; drops of rain jump each time
    double flicker = 4;            ///< times a pixel came and went in `flicker_memory`: tape in the wind
    double flicker_lengths = 0.4;  ///< part by which a mover must go farther there
    double flicker_memory = 20;    ///< seconds

    double no_signal =
        1;  ///< seconds without a frame where numbers of frames are missing: of that time nothing is known

    // Following from frame to frame.
    double lost_after = 1;                  ///< seconds for which a mover may be unseen and goes on with the same track
    double occluded_after = 3;              ///< the same within a larger object
    double stationary_occluded_after = 60;  ///< the same of a standing thing that has somebody in front of it
    double merge_cost = 0.85;               ///< cost of sharing a blob; a blob of its own must fit better than this
    double gate = 1;  ///< lengths by which a blob may be off the expected place, where nothing overlaps

    // Joining tracklets over gaps.
    double link_seconds = 8;  ///< longest gap; a person who is hidden for longer may be somebody else
    double link_cost = 1;     ///< most that a link may cost

    // Standing things.
    double visible = 0.3;       ///< share of its pixels in which a standing thing must be seen
    double undisturbed = 0.8;   ///< with so many of them seen nobody is in front of it
    double settled_part = 0.6;  ///< share of steady pixels that makes an object a standing one
};

}  // namespace vvr::events
