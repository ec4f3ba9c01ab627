#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

// What a recording itself did, whoever was in front of the camera. This table is all that fields, pictures, pages and
// reports know of a condition; condition_finder.cpp decides which one a frame is in.
namespace vvr::condition {

enum class Kind {
    normal,     ///< the camera watches its scene
    no_signal,  ///< there are no frames
    dropped,    ///< frames of a live stream came too fast
    unlearnt,   ///< the empty scene is being learnt
    frozen,     ///< the same picture again and again
    blank,      ///< a single colour, perhaps with a text
    damaged,    ///< packets are lost, and the pictures are decoded without them
    covered,    ///< hardly any edge of the scene can be seen
    turning,    ///< the camera shows another view than those that have an empty scene
    moved,      ///< from here on, the camera shows another view
    infrared,   ///< the camera changes to infrared or back
    light,      ///< much of the picture is in another light for a while
    times,      ///< the frames have almost the same timestamps, so that their times are guessed
};

/// One row of the table of conditions.
struct ConditionRow {
    Kind kind;
    std::string_view name;     ///< in reports
    std::string_view words;    ///< on pictures and pages
    std::string_view cause{};  ///< the likely one, if it is a fault that somebody may have to mend
};

/// The conditions, in the order of Kind.
inline constexpr std::array condition_rows{
    ConditionRow{Kind::normal, "normal", "normal"},
    ConditionRow{Kind::no_signal, "no_signal", "no signal"},
    ConditionRow{Kind::dropped, "dropped", "frames dropped"},
    ConditionRow{Kind::unlearnt, "unlearnt", "learning the scene"},
    ConditionRow{Kind::frozen, "frozen", "no new pictures", "the recorder repeated its last picture"},
    ConditionRow{Kind::blank, "blank", "no picture", "the recorder wrote a card instead of pictures"},
    ConditionRow{Kind::damaged, "damaged", "damaged", "packets were lost on the way to the recorder"},
    ConditionRow{Kind::covered, "covered", "too dark or covered", "it was too dark, or something covered the lens"},
    ConditionRow{Kind::turning, "camera_turning", "camera turning", "the camera was turned, or it tours several views"},
    ConditionRow{Kind::moved, "camera_moved", "camera moved", "somebody knocked against the camera or turned it"},
    ConditionRow{Kind::infrared, "infrared", "infrared on or off"},
    ConditionRow{Kind::light, "light_changed", "light changed", "a cloud, a lamp or the camera's exposure"},
    ConditionRow{Kind::times, "times_doubtful", "times doubtful", "the camera's clock went back, or frames came late"},
};

constexpr const ConditionRow& row_of(Kind kind) {
    return condition_rows[static_cast<std::size_t>(kind)];
}

/// A stretch of a clip in one condition, in seconds.
struct Interval {
    double begin = 0;  ///< time of the last frame before it
    double end = 0;    ///< time of the first frame after it
    Kind kind = Kind::no_signal;
};

/// In order, with those of one kind joined that follow each other at once.
std::vector<Interval> joined(std::vector<Interval> intervals);

/// Adds the time from one frame to the next to the intervals of its kind: it may continue the last one.
void lengthen(std::vector<Interval>& intervals, const Interval& more);

}  // namespace vvr::condition
