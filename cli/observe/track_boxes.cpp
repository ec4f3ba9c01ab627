#include "cli/observe/track_boxes.h"

#include <algorithm>
#include <iterator>

namespace vvr::app {

void add_boxes(const tracking::FrameLabels& labels, std::vector<TrackBox>& boxes) {
    const auto begin = std::ssize(boxes);
    for (const fields::LabelRun& run : labels.runs) {
        const PixelBox box{run.first, run.row, run.last + 1, run.row + 1};
        const auto of_frame = boxes.begin() + begin;
        const auto known =
            std::find_if(of_frame, boxes.end(), [&](const TrackBox& one) { return one.track == run.track; });
        if (known == boxes.end()) {
            boxes.push_back({labels.at.frame, run.track, box});
        } else {
            known->box = bounding_box(known->box, box);
        }
    }
}

}  // namespace vvr::app
