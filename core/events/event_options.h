#pragma once

namespace vvr::events {

/// All thresholds of event detection. Times are in seconds of the clip. Lengths are multiples of the object's own
/// length (the longer side of its box), and areas multiples of its own area, so that one set of numbers suits near and
/// far objects. Shares are from 0 to 1. Where a number has another unit, its comment names it.
struct Thresholds {
    double least_length = 4;  ///< field pixels; an object counts as no shorter, because its length is too uncertain

    /// What counts as an object in one field.
    struct {
        int reach = 192;  ///< blobs nearer than the field's longer side / 192 are one: filters cut people in two
        int area = 5000;  ///< blobs smaller than the field's area / 5000 are noise
        int pixels = 4;   ///< field pixels; smaller blobs are noise in a field of any size
        int edge = 2;     ///< field pixels on each side of an outline, between which its contrast is measured
    } blob;

    /// Data association: the blob in which a track goes on. Costs are weighted sums of two distances, each from 0 to 1:
    /// of places (1 - intersection over union) and of looks (Hellinger distance).
    struct {
        double gate = 1;              ///< lengths from the predicted place to a blob that the track does not overlap
        double area_ratio = 2.5;      ///< largest ratio of areas of track and blob where they do not overlap
        double cost = 0.85;           ///< a track gets a blob of its own only below this cost; else it may share one
        double place_weight = 0.8;    ///< weight of places, which tell single objects apart best
        double looks_weight = 0.2;    ///< weight of looks, which matter only where two objects meet
        double merged_place = 0.5;    ///< weight of places after a merge, when the place is only estimated
        double merged_looks = 0.8;    ///< weight of looks after a merge, when they tell the objects apart
        double apart = 0.5;           ///< base cost without overlap
        double apart_place = 0.25;    ///< weight of the distance / `gate` without overlap
        double apart_looks = 0.5;     ///< weight of looks without overlap
        double shared_part = 0.15;    ///< share of a track's area that must lie on a blob to share it with others
        double fragment_size = 1.15;  ///< times the usual size: fragments that fit in such a box are one object
    } association;

    /// How a track follows its blobs.
    struct {
        double velocity = 0.8;       ///< seconds over which velocity is measured: about one step of a pedestrian
        double abrupt = 1.5;         ///< ratio of areas between two frames that means a merge or a split
        double grows_in = 2;         ///< seconds in which the usual size adapts to a larger one
        double shrinks_in = 8;       ///< seconds in which it adapts to a smaller one: an occlusion may last that long
        double overlap = 0.3;        ///< share of the smaller box on the last or predicted one; less is a jump
        double lost_after = 1;       ///< seconds for which a moving object may be unseen before its track ends
        double leaving_share = 0.3;  ///< share of the usual area: with less of it at the border, the object has left
        double replaced = 1.6;       ///< times its least area at the border: a larger blob is somebody else
        int replaced_pixels = 10;    ///< field pixels beyond that, because small areas flicker
    } track;

    /// Where each of several objects is within a blob that they share.
    struct {
        double occluded_after = 3;  ///< seconds for which a moving object may be hidden in the blob
        double searched = 0.3;      ///< times the largest area in the blob; smaller objects match any part of a person
        double room = 0.75;         ///< share of the sum of all areas: in a blob as large, nobody hides another
        double similarity = 0.3;    ///< share of the template that must match; less can be chance
        double least_share = 0.35;  ///< share of the usual area that it needs to be found by looks instead
        double looks = 0.3;         ///< Hellinger distance from which two looks are those of different people
        double correction = 0.25;   ///< gain of the velocity's correction: a match is off by some pixels
        double slowing = 0.8;       ///< factor of the velocity, per field, of an object that the blob's edge holds back
        int search = 3;             ///< field pixels around the predicted place in which a template is searched
        double astray = 0.004;      ///< loss of similarity per squared field pixel from the predicted place
        int unlike = 72;            ///< levels of a colour channel from which two colours have nothing in common
    } merged;

    /// Pixels that flicker, and pixels that keep their value.
    struct {
        double memory = 20;  ///< seconds in which a counted change fades to 1/e
        double flicker = 4;  ///< counted changes per pixel that mean flicker, such as tape in the wind
        int level = 40;      ///< levels of the field; smaller changes are noise or edges of a codec's blocks
    } pixel;

    /// Stationary objects.
    struct {
        double stay = 2;             ///< seconds in one place; whoever stays for less has only slowed down
        double settled_part = 0.6;   ///< share of steady pixels that makes an object stationary
        double sways = 0.5;          ///< lengths per `stay`; a faster object does not sway but moves
        double carried = 0.5;        ///< share of the area of the object it split from; a smaller one was carried
        double rolls_out = 1;        ///< seconds for which a plain surface looks steady before it stops
        double apart = 0.6;          ///< lengths between two parts of one object
        double near_place = 0.5;     ///< lengths; an object that moved less stood there from the start
        double visible = 0.3;        ///< share of its pixels that must be seen for the object to be seen
        double undisturbed = 0.8;    ///< share of its pixels; if as many are seen, nobody is in front of it
        double occluded_after = 60;  ///< seconds for which it, or one of a group, may be occluded
        double same_place = 0.5;     ///< lengths between its centres before and after an occlusion
    } stationary;

    /// Factors apply to a portrait's score.
    struct {
        double every = 0.2;     ///< seconds between two candidates
        double merged = 0.3;    ///< factor for an object in a shared blob: a portrait of it alone is better
        double cut_off = 0.25;  ///< factor for an object that the border of the picture cuts
    } portrait;

    double no_signal = 1;  ///< seconds between two frames that make a gap, if numbers of frames are missing too

    /// Which tracklet continues another after a gap.
    struct {
        double seconds = 8;          ///< longest gap; whoever comes back later may be somebody else
        double overlap = 0.3;        ///< seconds by which the later one may begin before the earlier ends
        double border = 0.3;         ///< longest gap, in seconds, at the border of the picture, which hides nobody
        double straight = 1;         ///< seconds for which motion is extrapolated at constant velocity
        double area_ratio = 3;       ///< largest ratio of areas: a person may have come nearer
        double looks = 0.33;         ///< Hellinger distance from which people differ; 0.1 to 0.25 for one person
        double reach = 0.8;          ///< lengths by which the predicted place may be off,
        double reach_speed = 0.7;    ///< plus this share of the distance that its speed allows in the gap
        double least_speed = 0.3;    ///< lengths per second: whoever stands may start to walk
        double cost = 1;             ///< largest cost of a link, the sum of three terms:
        double place_weight = 0.35;  ///< weight of the distance / the largest allowed one
        double gap_weight = 0.25;    ///< weight of the gap / `seconds`
        double looks_weight = 0.6;   ///< weight of the distance of looks / `looks`
        double group_looks = 0.8;    ///< the only weight where both were in the same group
    } link;

    /// Two objects that enter as one blob and split. Ratios are the group's area / the area of one of them.
    struct {
        double least = 1.4;  ///< least ratio; in a smaller blob there was no second person
        double most = 3.3;   ///< largest ratio; in a crowd, no path is certain
        double share = 0.7;  ///< share of the group's area; while the blob was smaller, it was not yet the group
    } group;

    /// What counts as an event.
    struct {
        double least = 0.8;            ///< seconds; shorter ones are changes of light or fragments
        double least_inside = 2;       ///< seconds for one that neither enters nor leaves at the picture's border …
        double least_fragment = 5;     ///< … and for one that also split from another: mostly a part of it
        double own_lengths = 1.25;     ///< lengths it must move; a flag flutters in place
        double flicker_lengths = 0.4;  ///< share by which that grows per `pixel.flicker` of its pixels …
        double most_flicker = 3;       ///< … up to so many times `pixel.flicker`
        double seen_part = 0.5;        ///< share of its frames in which it must be seen; foliage comes and goes
        double steady_way = 0.25;      ///< mean cosine between steps of its path; leaves and rain turn back and forth
        double continuous = 0.75;      ///< share of its detections without a jump; raindrops jump each time
    } event;

    /// When an event is a fragment of another.
    struct {
        double inside = 0.6;  ///< share of its box that is inside the other's
        double shared = 0.7;  ///< share of its time for which that is so
        double size = 0.5;    ///< largest share of the other's area
    } fragment;

    /// Things that were left or taken, who did it, and ghosts.
    struct {
        double before = 3;          ///< seconds before a thing appears in which its bearer must be beside it …
        double after = 0.5;         ///< … or after it
        double most_between = 0.5;  ///< seconds per frame; at a lower rate the bearer may come and go unseen
        double edge_ratio = 1.3;    ///< ratio by which edges in the frame or the empty scene must be stronger
        double edges = 10;          ///< grey levels; weaker edges are light or noise
    } thing;

    /// Small events that crowd one part of the picture.
    struct {
        int size = 8;    ///< a small event stays within the picture's longer side / 8
        int least = 12;  ///< number of events; fewer can be read one by one
    } clutter;
};

inline constexpr Thresholds thresholds{};

/// What the thresholds can't know of a clip.
struct EventOptions {
    bool scene_is_learnt = true;  ///< the empty scene comes from the clip's own frames: it holds what all of them show
};

}  // namespace vvr::events
