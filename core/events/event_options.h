#pragma once

namespace vvr::events {

/// Every threshold by which events are found. Seconds are those of the clip. The unit of a length is the object's own
/// longer side, and that of an area its own area, so that one set of numbers serves near and far; a share is of 1.
/// What is in pixels of the field or in grey levels says so.
struct Thresholds {
    double least_length = 4;  ///< field pixels; the length of what is smaller can't be measured

    /// What is an object in one field.
    struct {
        int reach = 192;  ///< parts of the field's longer side; nearer blobs are one: a filter cuts a person in two
        int area = 5000;  ///< parts of the field; of less it is noise
        int pixels = 4;   ///< and of fewer in any field
        int edge = 2;     ///< pixels to each side of an outline between which its edge is: the field is smooth
    } blob;

    /// Which blob a track goes on in. A cost is a sum of distances of places and of looks, each 0 to 1.
    struct {
        double gate = 1;              ///< lengths off the expected place, where nothing overlaps
        double area_ratio = 2.5;      ///< of one thing from frame to frame, where nothing overlaps
        double cost = 0.85;           ///< of sharing a blob; a blob of its own must fit better than this
        double place_weight = 0.8;    ///< of the overlap, which tells most of who is alone …
        double looks_weight = 0.2;    ///< … and looks only who of two that meet
        double merged_place = 0.5;    ///< the same after a shared blob, where the place is a guess …
        double merged_looks = 0.8;    ///< … and looks tell who is who
        double apart = 0.5;           ///< for no overlap at all,
        double apart_place = 0.25;    ///< and of the distance,
        double apart_looks = 0.5;     ///< and of looks then
        double shared_part = 0.15;    ///< share of a track that falls on a blob in which it is not alone
        double fragment_size = 1.15;  ///< sizes that an object has with its fragments: they are no larger than it was
    } association;

    /// How a track follows its blobs.
    struct {
        double velocity = 0.8;       ///< seconds over which it is measured: about one step of a walker
        double abrupt = 1.5;         ///< areas; who is so much larger or smaller at once has met or lost something
        double grows_in = 2;         ///< seconds over which a larger size becomes the usual one
        double shrinks_in = 8;       ///< the same of a smaller one: it may be half hidden for that long
        double overlap = 0.3;        ///< share of the smaller box on where it was, or should be; less is a jump
        double lost_after = 1;       ///< seconds for which a mover may be unseen and goes on with the same track
        double leaving_share = 0.3;  ///< of its usual area that is still seen at the border: it has all but left
        double replaced = 1.6;       ///< times that, by which a blob is too large for who was leaving …
        int replaced_pixels = 10;    ///< … and pixels, as little areas flicker
    } track;

    /// Who of several is where in the blob that they share.
    struct {
        double occluded_after = 3;  ///< seconds for which a mover may be hidden in it
        double searched = 0.3;      ///< of the largest area in it; anything smaller is like some part of a person
        double room = 0.75;         ///< of what all are together; a blob that has it hides nobody
        double similarity = 0.3;    ///< share of the template that is more than chance
        double least_share = 0.35;  ///< of its usual area that it has to itself: then it is there, if it looks like it
        double looks = 0.3;         ///< distance of looks of different people
        double correction = 0.25;   ///< share by which a place in it corrects the velocity: it is off by some pixels
        double slowing = 0.8;       ///< of the velocity of who is held back by the blob's edge
        int search = 3;             ///< pixels about the expected place
        double astray = 0.004;      ///< similarity that a squared pixel away from there must make good
        int unlike = 72;            ///< levels of a channel at which two colours have nothing in common
    } merged;

    /// Pixels that come and go, and pixels that keep their value.
    struct {
        double memory = 20;  ///< seconds for which a change counts
        double flicker = 4;  ///< changes of late: tape in the wind, and no object that stands
        int level = 40;      ///< levels of a doubled difference that are noise and the seams of a codec's blocks
    } pixel;

    /// Standing things.
    struct {
        double stay = 2;             ///< seconds; who keeps a place for less has only slowed down
        double settled_part = 0.6;   ///< share of steady pixels that makes an object a standing one
        double sways = 0.5;          ///< lengths in `stay` seconds that are more than swaying
        double carried = 0.5;        ///< of the area of whom it came out of; a smaller one was carried
        double rolls_out = 1;        ///< seconds for which what is of one colour looks steady before it stops
        double apart = 0.6;          ///< lengths between two parts of one thing
        double near_place = 0.5;     ///< lengths that it moved at most: it was there from its first moment
        double visible = 0.3;        ///< share of its pixels in which it must be seen
        double undisturbed = 0.8;    ///< with so many of them seen nobody is in front of it
        double occluded_after = 60;  ///< seconds for which it, or one of a group, may be hidden behind somebody
        double same_place = 0.5;     ///< lengths by which its middle may be off when it comes to light again
    } stationary;

    struct {
        double every = 0.2;     ///< seconds between looks for a better one
        double merged = 0.3;    ///< worth of one with others in it; who is never alone has no better one
        double cut_off = 0.25;  ///< worth of one that the border of the picture cuts
    } portrait;

    double no_signal = 1;  ///< seconds without a frame where numbers of frames are missing: nothing is known of them

    /// Which tracklet goes on in which, over a gap.
    struct {
        double seconds = 8;        ///< longest gap; a person who is hidden for longer may be somebody else
        double overlap = 0.3;      ///< seconds by which the later may begin before the earlier ends
        double border = 0.3;       ///< seconds of a gap at the border of the picture: it hides nobody
        double straight = 1;       ///< seconds for which a velocity still tells where it goes
        double area_ratio = 3;     ///< of one object: it may come nearer
        double looks = 0.33;       ///< distance of looks of different people; of one person it is 0.1 to 0.25
        double reach = 0.8;        ///< lengths by which it may be off,
        double reach_speed = 0.7;  ///< and of the way that it may have gone meanwhile at its speed,
        double least_speed = 0.3;  ///< lengths per second: who stands may go
        double cost = 1;           ///< most that a link may cost, by
        double place_weight = 0.35;
        double gap_weight = 0.25;
        double looks_weight = 0.6;
        double group_looks = 0.8;  ///< within a group that both were seen in, looks alone
    } link;

    /// Two that come as one blob and part.
    struct {
        double least = 1.4;  ///< areas of one of them: less is no second person
        double most = 3.3;   ///< and more is a crowd, in which nobody knows who was where
        double share = 0.7;  ///< of the group's area; before it was that large, it was not the group yet
    } group;

    /// What is an event.
    struct {
        double least = 0.8;            ///< seconds; what is seen for less is a blink of the light or a fragment
        double least_inside = 2;       ///< the same of what neither comes in nor goes out at the picture's border
        double least_fragment = 5;     ///< and of such that came out of another: a part of it, mostly
        double own_lengths = 1.25;     ///< what goes less far than this flutters at its place, as a flag does
        double flicker_lengths = 0.4;  ///< share by which a mover must go farther where pixels flicker, and
        double most_flicker = 3;       ///< times `pixel.flicker` that count
        double seen_part = 0.5;        ///< share of its frames in which a mover is seen; foliage comes and goes
        double steady_way = 0.25;  ///< cosine between steps half a second apart: leaves and rain turn back and forth
        double continuous = 0.75;  ///< share of a mover's sightings without a jump; drops of rain jump each time
    } event;

    /// What is a fragment of another event.
    struct {
        double inside = 0.6;  ///< share of its box in the other's
        double shared = 0.7;  ///< share of its time
        double size = 0.5;    ///< of the other's area
    } fragment;

    /// What was left or taken, by whom, and what is a ghost.
    struct {
        double before = 3;          ///< seconds before a thing comes to light in which its bearer was there,
        double after = 0.5;         ///< and after
        double most_between = 0.5;  ///< seconds from frame to frame; in more, somebody may come and go
        double edge_ratio = 1.3;    ///< by which edges must be stronger, in the frame or in the empty scene
        double edges = 10;          ///< grey levels; weaker ones are those of light and noise
    } thing;

    /// Small events that crowd one part of the picture.
    struct {
        int size = 8;    ///< parts of the picture's longer side that one never leaves
        int least = 12;  ///< fewer can be read one by one
    } clutter;
};

inline constexpr Thresholds thresholds{};

/// What the thresholds don't know of a clip.
struct EventOptions {
    bool scene_is_learnt = true;  ///< the empty scene is of the clip's own frames: what all of them show belongs to it
};

}  // namespace vvr::events
