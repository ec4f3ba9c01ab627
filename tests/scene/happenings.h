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

/// Somebody comes early, stands for more than half of the time and goes. Object "person". 500 frames.
Scene make_stands_long(const Options& options = {});
Interval long_stand();

/// A camera's clock counts in a corner; nothing else happens. 300 frames.
Scene make_clock(const Options& options = {});

/// Somebody walks through. Object "person". 250 frames.
Scene make_walks_by(const Options& options = {});

/// Somebody comes, stands in the middle for 8 s, and goes on. Object "person". 350 frames.
Scene make_stands(const Options& options = {});

/// Somebody comes from the wall towards the camera, and passes it on the right. Object "person". 250 frames.
Scene make_comes_closer(const Options& options = {});

}  // namespace vvr::generator
