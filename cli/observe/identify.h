#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string_view>
#include <vector>

#include "cli/plan/options.h"
#include "core/annotation/crops.h"
#include "core/detector/detector.h"
#include "core/media/frame.h"
#include "core/tracking/event.h"
#include "core/tracking/identify.h"

// The object detector looks at the events of a clip.
namespace vvr::app {

/// Reads the job's model; null if it has none.
/// \throws Error not_a_model, io
std::shared_ptr<detector::Detector> open_detector(const DetectorOptions& options);

/// The largest number of pictures of one object that a detector looks at.
inline constexpr int most_looks = 3;

/// What a detector was used for.
struct DetectorUse {
    std::string_view format;  ///< of its model
    std::int64_t events = 0;  ///< that it looked at
    std::int64_t looks = 0;   ///< pictures of them
    std::int64_t frames = 0;  ///< whole frames, for the empty scene
    double seconds = 0;       ///< for all looks
};

/// Looks at pictures of events, up to three of each. It looks at a picture only once, also when the events of a stream
/// are found again and again.
class ObjectClassifier {
  public:
    /// \param detector must outlive this object
    /// \param threads at most; 0 = one per core
    ObjectClassifier(detector::Detector& detector, int threads) : detector_(&detector), threads_(threads) {
        use_.format = detector.format();
    }

    /// Sets the identities of the most important events, and refutes claims.
    /// \returns the use so far
    const DetectorUse& identify(tracking::Findings& found, const annotation::Crops& crops);

    /// The people, vehicles and animals in a frame, field pixels.
    std::vector<PixelBox> living_in(const media::Frame& frame);

  private:
    /// What the detector found in a picture, by track and score of the picture.
    using Answers = std::map<std::pair<std::size_t, double>, tracking::Look>;

    std::vector<tracking::Look> looks_at(const tracking::Event& event, const annotation::Crops& crops,
                                         Answers& current);
    tracking::Look look_at(const annotation::Crop& crop);

    detector::Detector* detector_;
    int threads_;
    Answers answers_;
    DetectorUse use_;
};

}  // namespace vvr::app
