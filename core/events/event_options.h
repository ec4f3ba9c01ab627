#pragma once

#include <array>

namespace vvr::events {

/// A term of evidence: from the value at which it is no evidence to the value at which it is certain. A claim needs
/// half of the way.
struct Ramp {
    double none = 0;
    double certain = 1;
};

/// All thresholds of event detection. Times are in seconds of the clip. Lengths are multiples of the object's own
/// length (the longer side of its box) and areas multiples of its own area, so that one set of numbers suits near and
/// far objects. A share is from 0 to 1. A comment names the unit first, and any other unit.
struct Thresholds {
    double least_length = 4;  ///< field pixels; a shorter length is too uncertain, so this replaces it

    /// What counts as an object in one field.
    struct {
        int reach = 192;  ///< field's longer side / 192: blobs nearer than this are one, as filters cut people in two
        int area = 5000;  ///< field's area / 5000: smaller blobs are noise
        int pixels = 4;   ///< field pixels; smaller blobs are noise in any field
        int edge = 2;     ///< field pixels on each side of an outline across which contrast is measured
    } blob;

    /// Data association: the blob in which a track goes on. Costs are weighted sums of two distances, each from 0 to 1:
    /// of places (1 - intersection over union) and of looks (Hellinger distance).
    struct {
        double gate = 1;              ///< lengths; largest distance from the predicted place to a blob without overlap
        double area_ratio = 2.5;      ///< ratio; largest change of area to a blob without overlap
        double cost = 0.85;           ///< cost below which a track gets its own blob; else it may share one
        double place_weight = 0.8;    ///< weight of places, which tell single objects apart best
        double looks_weight = 0.2;    ///< weight of looks, which matter only where two objects meet
        double merged_place = 0.5;    ///< weight of places after a merge, when the place is only estimated
        double merged_looks = 0.8;    ///< weight of looks after a merge, when they tell the objects apart
        double apart = 0.5;           ///< base cost without overlap
        double apart_place = 0.25;    ///< weight of the distance / `gate` without overlap
        double apart_looks = 0.5;     ///< weight of looks without overlap
        double shared_part = 0.15;    ///< share of a track's area; least part on a blob that it shares with others
        double fragment_size = 1.15;  ///< usual sizes; fragments that fit into a box of this size are one object
    } association;

    /// How a track follows its blobs.
    struct {
        double velocity = 0.8;  ///< seconds over which velocity is measured: about one step of a walker
        double abrupt = 1.5;    ///< ratio of areas between two frames from which two objects merged or split
        double grows_in = 2;    ///< seconds in which the usual size adapts to a larger one
        double shrinks_in = 8;  ///< seconds in which it adapts to a smaller one: an occlusion may last that long
        double overlap = 0.3;   ///< share of the smaller box; less overlap with its last or predicted box is a jump
        double lost_after = 1;  ///< seconds for which a moving object may be unseen before its track ends
        double leaving_share = 0.3;  ///< share of the usual area: with less of it at the border, the object has left
        double replaced = 1.6;       ///< ratio to its least area at the border: a larger blob is another object …
        int replaced_pixels = 10;    ///< … if it has this many field pixels more: small areas flicker
    } track;

    /// Where each of several objects is within a blob that they share.
    struct {
        double occluded_after = 3;  ///< seconds for which a moving object may be hidden in the blob
        double searched = 0.3;    ///< areas of the largest object in the blob; smaller ones match any part of a person
        double room = 0.75;       ///< share of the sum of all areas; a larger blob occludes none of them
        double similarity = 0.3;  ///< share of the template; a smaller match may be chance
        double least_share = 0.35;  ///< share of the usual area; least part to accept an object without template match
        double looks = 0.3;         ///< Hellinger distance; from here on, looks are those of different people
        double correction = 0.25;   ///< gain of the velocity's correction: a match is off by some pixels
        double slowing = 0.8;       ///< factor per field of the velocity of an object that the blob's edge stops
        int search = 3;             ///< field pixels; search radius around the predicted place
        double astray = 0.004;      ///< similarity lost per squared field pixel of distance from the predicted place
        int unlike = 72;            ///< levels of a channel; from here on, two colours have nothing in common
    } merged;

    /// Pixels that flicker, and pixels that keep their value.
    struct {
        double memory = 20;  ///< seconds in which a change's count decays to 1/e
        double flicker = 4;  ///< changes per pixel; from here on, it flickers, as tape in the wind does
        int level = 40;  ///< field values (twice the grey levels); smaller changes are noise or a codec's block edges
    } pixel;

    /// Stationary objects.
    struct {
        double stay = 2;             ///< seconds in one place; an object that stays shorter has only slowed down
        double settled_part = 0.6;   ///< share of its pixels that must be steady
        double sways = 0.5;          ///< lengths per `stay`; a faster object moves, a slower one only sways
        double carried = 0.5;        ///< share of the area of the object from which it split; a smaller one was carried
        double rolls_out = 1;        ///< seconds for which a plain surface looks steady before it stops
        double apart = 0.6;          ///< lengths; largest gap between two parts of one object
        double near_place = 0.5;     ///< lengths; an object that moved less was there from the start
        double visible = 0.3;        ///< share of its pixels; with fewer visible, it is not seen
        double undisturbed = 0.8;    ///< share of its pixels; with more visible, nobody occludes it
        double occluded_after = 60;  ///< seconds for which a stationary object, or one of a group, may be occluded
        double gone_after = 1;       ///< seconds for which its place must be uncovered before it is gone
        double same_place = 0.5;     ///< lengths; largest shift of its centre over an occlusion
    } stationary;

    /// Which portrait of an object is kept. Factors apply to its score.
    struct {
        double every = 0.2;     ///< seconds between two candidates
        double merged = 0.3;    ///< factor for an object in a shared blob: a portrait of it alone is better
        double cut_off = 0.25;  ///< factor for an object that the border of the picture cuts
    } portrait;

    double no_signal = 1;  ///< seconds between two frames; at least this, with frame numbers missing, is a gap

    /// Which tracklet continues another after a gap.
    struct {
        double seconds = 8;          ///< seconds; longest gap, as a person who appears later may be somebody else
        double overlap = 0.3;        ///< seconds; longest overlap in time
        double border = 0.3;         ///< seconds; longest gap at the border of the picture, where nothing occludes
        double straight = 1;         ///< seconds for which velocity is extrapolated
        double area_ratio = 3;       ///< ratio of areas; the largest for one person, who may have come nearer
        double looks = 0.33;         ///< Hellinger distance; largest for one person, whose looks vary by 0.1 to 0.25
        double reach = 0.8;          ///< lengths; largest distance from the predicted place …
        double reach_speed = 0.7;    ///< … plus this share of the way that it can go in the gap at its speed
        double least_speed = 0.3;    ///< lengths per second; least speed assumed, as a standing person may walk on
        double cost = 1;             ///< cost from which tracklets aren't linked: the sum of the next three terms
        double place_weight = 0.35;  ///< weight of the distance / its largest value
        double gap_weight = 0.25;    ///< weight of the gap / `seconds`
        double looks_weight = 0.6;   ///< weight of the distance of looks / `looks`
        double group_looks = 0.8;    ///< weight of looks, the only term, if both were in one group
    } link;

    /// Two objects that enter as one blob and split. Ratios are the group's area / the area of one of them.
    struct {
        double least = 1.4;  ///< ratio; a smaller blob was no group
        double most = 3.3;   ///< ratio; a larger blob was a crowd, in which no path is certain
        double share = 0.7;  ///< share of the group's area; a smaller blob was not yet the group
    } group;

    /// What counts as an event.
    struct {
        double least = 0.8;            ///< seconds; shorter ones are flashes of light or fragments
        double least_inside = 2;       ///< seconds, for one that neither enters nor leaves at the picture's border
        double least_fragment = 5;     ///< seconds, for such a one that split from another: mostly a part of it
        double own_lengths = 1.25;     ///< lengths; a moving object goes at least this far, a flag flutters in place
        double flicker_lengths = 0.4;  ///< share by which that distance grows per `pixel.flicker` of its pixels …
        double most_flicker = 3;       ///< … up to this multiple of `pixel.flicker`
        double seen_part = 0.5;        ///< share of its frames in which it is seen, at least; foliage comes and goes
        double steady_way = 0.25;      ///< mean cosine between steps of its path, at least; leaves and rain turn back
        double continuous = 0.75;      ///< share of its detections without a jump, at least; raindrops jump each time
    } event;

    /// When an event is a fragment of another.
    struct {
        double inside = 0.6;  ///< share of its box that lies inside the other's
        double shared = 0.7;  ///< share of its duration for which it does
        double size = 0.5;    ///< share of the other's area; a larger one is no fragment
    } fragment;

    /// The evidence for a claim ("left behind", "taken"); see `Evidence`.
    struct {
        double every = 0.2;       ///< seconds between two frames of the mean picture
        double remembered = 60;   ///< seconds for which the share of the picture that differs is remembered
        double told = 0.5;        ///< confidence; with less, it is a change and no event
        double overlap = 0.3;     ///< share of the smaller one that the region and the steady pixels have in common
        double least_area = 0.5;  ///< share of the steady pixels' area; a smaller region is a remainder
        std::array<int, 9> levels{6, 8, 11, 16, 22, 32, 45, 64, 90};  ///< grey levels that compete for the outline
        Ramp difference{2, 14};                                       ///< grey levels
        Ramp outline{2, 10};                                          ///< grey levels between both outlines
        Ramp thickness{0.05, 0.25};                                   ///< share of its length
        Ramp alone{0, 6};                                             ///< seconds
        Ramp moved{1.6, 0.2};                                         ///< lengths
        double alive = 1.4;                                           ///< lengths; what moved as far is no thing
        Ramp flicker{7, 1};                                           ///< changes per pixel
        Ramp changed{0.6, 0.2};                                       ///< share of the picture
    } claim;

    /// A clock that the camera writes into its pictures.
    struct {
        double window = 60;         ///< seconds in which changes are counted: the clip's time and the clock drift apart
        double every = 10;          ///< seconds between two looks
        double most_between = 0.4;  ///< seconds; after a longer gap, the phase of a change is unknown
        int level = 32;             ///< grey levels; smaller changes are noise
        int least = 10;             ///< seconds in which a pixel changed; fewer may be in phase by chance
        double least_rate = 0.2;    ///< share of all seconds: a stroke is in about half of the digits
        double most_per_second = 1.5;  ///< changes in each of these seconds
        double in_phase = 0.7;         ///< length of the mean of their phases
        double rayleigh = 12;  ///< changes x that length squared; by chance, it is larger in exp(-12) of all pixels
        int stroke = 3;        ///< pixels between two strokes of a digit
        int pixels = 6;        ///< pixels that change in phase
        double height = 0.15;  ///< of the picture's; a digit is smaller
        double inside = 0.7;   ///< share of an object's box; with more of it on the clock, it is digits
    } overlay;

    /// Things that were left or taken, who did it, and ghosts.
    struct {
        double before = 3;       ///< seconds before a thing appears: its bearer is beside it from then …
        double after = 0.5;      ///< … until this many seconds after
        double least_share = 1;  ///< areas of the thing; a smaller object can't have carried it
    } thing;

    /// What a detector tells of an object.
    struct {
        double score = 0.5;    ///< probability; with less, nano-sized models confuse things with people
        double overlap = 0.3;  ///< share of the object's box, or of both boxes; what overlaps less is something else
        int looks = 3;         ///< pictures of one object
        int events = 200;      ///< per clip, the most important ones: a look takes 50 to 100 ms
        double inside = 0.7;   ///< share of a part's box that lies inside the box of the whole object
        double shared = 0.7;   ///< share of a part's time for which it does
    } detector;

    /// Small events that crowd one part of the picture.
    struct {
        int size = 8;    ///< picture's longer side / 8: a small event stays within it
        int least = 12;  ///< events; fewer can be read one by one
    } clutter;
};

#ifdef VVR_THRESHOLDS_VARY
inline Thresholds thresholds{};  // tests/bench/sensitivity.cpp walks through them
#else
inline constexpr Thresholds thresholds{};
#endif

/// What the thresholds can't know of a clip.
struct EventOptions {
    bool scene_is_learnt = true;  ///< the empty scene comes from the clip's own frames: it holds what all of them show
    bool labels = true;           ///< `EventFinder::add` gives the pixels of each track
};

}  // namespace vvr::events
