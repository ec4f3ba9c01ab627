#pragma once

#include <optional>
#include <vector>

#include "core/fields/planes.h"
#include "core/tracking/event.h"
#include "core/tracking/patch.h"

// The evidence that something was left behind or taken.
namespace vvr::tracking {

/// The mean picture of a stationary object and of its surroundings over its stay. A single frame may show a sliver of a
/// dark bag before a dark cabinet; the mean shows all of it.
class StillPicture {
  public:
    StillPicture() = default;

    /// \param patch the object's pixels; the picture reaches one length beyond them, within the field
    StillPicture(const Patch& patch, Size field);

    /// Adds a frame in which nothing occludes the object. Frames that follow one another too closely are skipped.
    void add(const FrameView& frame, const Moment& now);

    bool empty() const { return count_ == 0; }
    const PixelBox& box() const { return box_; }

    /// The mean of all added frames, of the box.
    fields::Planes mean() const;

  private:
    PixelBox box_;
    int count_ = 0;
    double due_ = 0;  ///< seconds: time of the next frame
    std::vector<glm::vec3> sum_;
};

/// How the mean picture of a stay differs from the empty scene.
struct SceneComparison {
    Patch region;            ///< the pixels that differ, in the field
    double difference = 0;   ///< mean difference over the region, grey levels
    double edges = 0;        ///< contrast of the mean picture across the region's outline, grey levels
    double scene_edges = 0;  ///< the same of the empty scene
    double thickness = 0;    ///< largest distance to the outline / half of the region's length; 1 = a disk
};

/// Compares the mean picture of a stay with the empty scene. Of several levels of difference, that one is chosen for
/// whose region the outline's contrast differs most between both pictures: a thing has an outline in one of them.
/// \param settled the pixels that were steady; the region must overlap them
/// \returns nothing where no region differs
std::optional<SceneComparison> compare_with_scene(const StillPicture& still, const Patch& settled,
                                                  const fields::Planes& scene);

/// The confidence of a claim, 0 to 1: that of its weakest term.
double confidence_of(const Evidence& evidence);

}  // namespace vvr::tracking
