#pragma once

#include "tests/scene/figure.h"
#include "tests/scene/scene.h"

namespace vvr::generator {

/// A story in the hall, told in frames of its own and in pixels of a picture that is 288 high. Options scale both.
class HallStory : public Story {
  protected:
    HallStory(const Options& options, double story_frames)
        : time_scale_(story_frames / options.frames),
          scale_(options.size.height / 288.0),
          width_(options.size.width / scale_),
          hall_(paint_hall(options.size, options.seed, options.detail)),
          seed_(options.seed) {}

    /// Of the one person, and of the floor below, pixels.
    double height() const { return 92 * scale_; }
    double floor() const { return 236 * scale_; }

    double time_scale_;
    double scale_;
    double width_;
    Plane<Bgr> hall_;
    std::uint64_t seed_;
};

}  // namespace vvr::generator
