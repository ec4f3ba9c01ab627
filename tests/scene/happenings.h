#pragma once

#include "tests/scene/scene.h"

// Small scenes of one happening each, for which the events are known to the frame. Options count but for `u`, `v` and
// `omega`; a picture of 192x144 is enough, and quick.
namespace vvr::generator {

/// Where a happening begins and ends.
struct Interval {
    int first = 0;  ///< frame
    int last = 0;
};

/// Two people who walk to and fro in each other's way and cross ten times. Objects "person 0" and "person 1". 520
/// frames.
Scene make_ten_crossings(const Options& options = {});

/// Two people come in side by side as one blob; half-way one of them turns and goes back. 300 frames.
Scene make_group_splits(const Options& options = {});

/// A train comes in, stands, and goes on; its windows show the wall behind, so that it is many pieces. Somebody walks
/// by in front of it meanwhile. Objects "train" and "person". 500 frames.
Scene make_train(const Options& options = {});
Interval train_stands();

/// Somebody puts down a bag of two stripes that differ little from the floor, and nothing of it between them, and
/// leaves. Objects "person" and "bag". 400 frames.
Scene make_pale_bag(const Options& options = {});
Interval pale_bag_stands();

/// Somebody comes and takes a box away that has always been there. Objects "person" and "box", which is where it was.
/// 400 frames.
Scene make_taken_box(const Options& options = {});
Interval box_is_gone();

/// Streaks of rain, here and there in each frame, and somebody who walks through it. Object "person". 250 frames.
Scene make_rain(const Options& options = {});

/// People walk through in both directions without an end. 400 frames.
Scene make_crowd(const Options& options = {});

/// The same for a minute. 1500 frames.
Scene make_long_crowd(const Options& options = {});

/// Somebody comes early, stands for more than half of the time and goes. Object "person". 500 frames.
Scene make_stands_long(const Options& options = {});
Interval long_stand();

/// Somebody walks through. Object "person". 250 frames.
Scene make_walks_by(const Options& options = {});

/// Somebody comes, stands in the middle for 8 s, and goes on. Object "person". 350 frames.
Scene make_stands(const Options& options = {});

/// Somebody comes from the wall towards the camera, and passes it on the right. Object "person". 250 frames.
Scene make_comes_closer(const Options& options = {});

// The surroundings change, and nothing is left or taken.

/// A camera's clock counts in a corner; nothing else happens. Its minute changes once. Object "clock". 750 frames.
Scene make_clock(const Options& options = {});
/// The boxes of its hours to seconds, and of the two digits of its seconds, in a picture of 192x144.
PixelBox clock_line();
PixelBox clock_seconds();

/// The same clock over leaves in the wind. 1000 frames.
Scene make_clock_over_leaves(const Options& options = {});

/// Somebody walks by behind the digits of a clock at the bottom. Objects "person" and "clock". 600 frames.
Scene make_clock_and_walker(const Options& options = {});

/// Three balloons on strings sway by half their size, from the first frame to the last. 750 frames.
Scene make_balloons(const Options& options = {});

/// A lamp brightens a quarter of the picture from `lamp_on` to the end. 500 frames.
Scene make_lamp(const Options& options = {});
int lamp_on();

/// The same lamp, and somebody who walks through its light just then. Object "person". 500 frames.
Scene make_lamp_and_walker(const Options& options = {});

// People and their belongings.

/// Somebody waits for a minute in one place, and sways a little. Object "person". 2375 frames.
Scene make_waits(const Options& options = {});
Interval minute_of_waiting();

/// The same, but they come at once: the place can be seen empty for a tenth of the time only. 1750 frames.
Scene make_waits_early(const Options& options = {});

/// Three people stand from the first frame on, and walk away after ten seconds. Objects "person 0" to "person 2".
Scene make_people_from_first(const Options& options, int frames);

/// Somebody puts down a bag that is 30 grey levels paler than the floor, and leaves. Objects "person" and "bag". 450
/// frames.
Scene make_faint_bag(const Options& options = {});
Interval faint_bag_stands();

/// Somebody brings a bag and puts it down; somebody else takes it along. Objects "person 0", "person 1" and "bag". 800
/// frames.
Scene make_bag_of_two(const Options& options = {});
Interval bag_of_two_stands();

}  // namespace vvr::generator
