#pragma once

#include <array>

#include "core/tracking/signs.h"

namespace vvr::tracking {

/// All thresholds of event detection. Times are in seconds of the clip. Lengths are multiples of the object's own
/// length (the longer side of its box) and areas multiples of its own area, so that one set of numbers suits near and
/// far objects. A share is from 0 to 1. A comment names the unit first, and any other unit. tests/bench/events.py
/// prints what a change of each number by a quarter does.
struct Thresholds {
    double least_length = 4;  ///< field pixels; a shorter length is too uncertain, so this replaces it
    double most = 0.5;        ///< share that counts as most: of an object's frames, of its box, of its pixels
    double memory = 60;       ///< seconds for which what was seen counts: a stationary object may be occluded as long
    double bearer = 3;        ///< seconds before or after a thing appears or goes: its bearer is beside it within them

    /// What counts as an object in one field.
    struct {
        int reach = 192;  ///< field's longer side / 192: blobs nearer than this are one, as filters cut people in two
        int area = 5000;  ///< field's area / 5000: smaller blobs are noise
    } blob;

    /// Data association: the blob in which a track goes on. The cost is a weighted sum of two distances, each from 0 to
    /// 1: of places (1 - intersection over union) and of looks (Hellinger distance).
    struct {
        double gate = 1;            ///< lengths; largest distance from the predicted place to a blob without overlap
        double cost = 0.85;         ///< cost below which a track gets its own blob; else it may share one
        double place_weight = 0.8;  ///< weight of places, which tell single objects apart best; looks have the rest
        double lost_place = 0.5;    ///< weight of places where the place is only estimated: after a merge or a gap …
        double lost_looks = 0.8;    ///< … and weight of looks there
        double shared_part = 0.15;  ///< share of a track's area; least part on a blob that it shares with others
        double fragment_size = 1.15;  ///< usual sizes; fragments that fit into a box of this size are one object
    } association;

    /// How a track follows its blobs.
    struct {
        double velocity = 0.8;    ///< seconds over which velocity is measured: about one step of a walker
        double abrupt = 1.5;      ///< ratio of areas between two frames from which two objects merged or split
        double adapts_in = 3;     ///< seconds in which the usual size adapts
        double lost_after = 0.7;  ///< seconds for which an object may be unseen, or its place uncovered
    } track;

    /// Where each of several objects is within a blob that they share.
    struct {
        double occluded_after = 3;  ///< seconds for which a moving object may be hidden in the blob
        double searched = 0.3;      ///< areas of the largest object; smaller ones match any part of a person
        double similarity = 0.3;    ///< share of the template; a smaller match may be chance
        double correction = 0.25;   ///< gain of the velocity's correction: a match is off by some pixels
        int search = 3;             ///< field pixels; search radius around the predicted place
        double astray = 0.004;      ///< similarity lost per squared field pixel of distance from the predicted place
        int unlike = 72;            ///< levels of a channel; from here on, two colours have nothing in common
    } merged;

    /// Pixels that flicker, and pixels that keep their value.
    struct {
        double memory = 20;  ///< seconds in which a change's count decays to 1/e
        double flicker = 4;  ///< changes per pixel; from here on, it flickers, as tape in the wind and leaves do
        int level = 40;      ///< field values (twice the grey levels); smaller changes are noise or block edges
    } pixel;

    /// Stationary objects.
    struct {
        double stay = 2;    ///< seconds in one place; an object that stays shorter has only slowed down
        int sightings = 4;  ///< fields in one place, as well; a walker may be at the same place in two by chance
        double settled_part = 0.6;  ///< share of its pixels that must be steady
        double apart = 0.6;         ///< lengths; largest gap between two parts of one object, or shift of its place
        double near_place = 0.75;   ///< widths or heights; an object that moved less was there from the start
        double uncovered = 3;      ///< ratio of its place's outline in the empty scene to that in its stay: it had left
        double undisturbed = 0.8;  ///< share of its pixels; with more visible, nobody occludes it
    } stationary;

    /// Which tracklet continues another after a gap. The cost is the mean of the distance, the gap and the looks, each
    /// as a share of its largest value.
    struct {
        double seconds = 8;   ///< seconds; longest gap, as a person who appears later may be somebody else
        double looks = 0.25;  ///< Hellinger distance; largest for one person, whose looks vary by 0.1 to 0.25
        double reach = 0.8;   ///< lengths; largest distance from the predicted place, beside its way in the gap
    } link;

    /// Two objects that enter as one blob and split: the group's area / the area of one of them.
    struct {
        double least = 1.4;  ///< ratio; a smaller blob was no group
        double most = 3.3;   ///< ratio; a larger blob was a crowd, in which no path is certain
    } group;

    /// What counts as an event.
    struct {
        double least = 0.8;         ///< seconds; shorter ones are flashes or fragments
        double probability = 0.35;  ///< from its signs, at least: see signs.h
        double own_lengths = 0.55;  ///< lengths; a moving object goes at least this far, a flag flutters in place
        double continuous = 0.75;   ///< share of its detections without a jump, at least; raindrops jump each time
    } event;

    /// Evidence for a claim ("left behind", "taken"): the values at which a claim can just be made. At none of it, or
    /// at twice a value that must be small, the confidence is 0; at twice a value that must be large, it is 1.
    struct {
        double sampled = 0.2;     ///< seconds between two frames of a mean picture, or between two portraits
        double difference = 7;    ///< grey levels, at least, between the stay and the empty scene
        double outline = 6;       ///< grey levels, at least, between both outlines: a thing has one in one picture only
        double ratio = 2;         ///< of both outlines, at least: leaves and reflections have some in both pictures
        double thickness = 0.15;  ///< share of its length, at least: a thing that was only shifted is a sliver
        double moved = 0.8;       ///< lengths that it moved by itself, at most; from twice as many on, it is no thing
        double novelty = 0.18;    ///< Hellinger distance to the scene's looks, at least; a door or a flag has less
        double uncertain = 0.25;  ///< confidence; from here to 0.5, it only says that the place was changed
        double changed = 0.4;     ///< share of the picture that differed when it appeared, at most: a train, a lamp
        std::array<int, 9> levels{6, 8, 11, 16, 22, 32, 45, 64, 90};  ///< grey levels that compete for the outline
    } claim;

    /// A clock that the camera writes into its pictures.
    struct {
        double every = 10;             ///< seconds between two looks; a stroke changes in as many seconds at least
        double most_between = 0.4;     ///< seconds; after a longer gap, the phase of a change is unknown
        int level = 32;                ///< grey levels; smaller changes are noise
        double most_per_second = 1.5;  ///< changes in each of these seconds
        double in_phase = 0.7;         ///< length of the mean of their phases
        double rayleigh = 12;  ///< changes x that length squared; by chance, it is larger in exp(-12) of all pixels
        int stroke = 3;        ///< pixels between two strokes of a digit
        double height = 0.15;  ///< of the picture's; a digit is smaller
    } overlay;

    /// What a detector says of an object.
    struct {
        double score = 0.5;    ///< probability; with less, nano-sized models confuse things with people
        double overlap = 0.3;  ///< share of the object's box, or of both boxes; what overlaps less is something else
    } detector;
};

VVR_NUMBERS Thresholds thresholds{};

/// What the thresholds can't know of a clip.
struct EventOptions {
    bool scene_is_learnt = true;  ///< the empty scene comes from the clip's own frames: it holds what all of them show
    bool labels = true;           ///< `EventFinder::add` gives the pixels of each track
};

}  // namespace vvr::tracking
