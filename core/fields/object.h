#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/plane.h"
#include "core/fields/blobs.h"
#include "core/fields/field.h"
#include "core/fields/illumination.h"
#include "core/fields/options.h"
#include "core/fields/planes.h"
#include "core/fields/reference.h"
#include "core/fields/running_reference.h"

namespace vvr::fields {

/// The result of background subtraction for one frame.
struct FoundObject {
    Plane<std::uint8_t> values;
    Plane<std::uint8_t> darker;  ///< not 0 where the frame is darker than the empty scene; empty unless requested
    bool learning = false;       ///< most of the picture has changed, so nothing is known of objects
    std::shared_ptr<const NewScene> scene{};  ///< as Field::scene
    double other_light = 0;                   ///< share of the picture that is in another light than the rest
    double middle_grey = 0;                   ///< level of the scene's middle grey in the light of the whole picture
};

/// Background subtraction: finds the difference object of §4 (Fig. 4a), the pixels that differ from the empty scene
/// under the norm. A hysteresis threshold keeps blobs whose strongest pixels reach the threshold. Both of its levels
/// rise where the scene itself is noisy. Values are twice the difference, 255 at most, because people and bags seldom
/// differ by more than half the range.
class ObjectFinder {
  public:
    /// \param reference the empty scene, not smoothed
    /// \param threshold grey levels
    /// \param region where to look; empty = everywhere. Must live as long as the finder.
    /// \param marks_darker whether FoundObject::darker is needed
    /// \throws Error usage if the norm needs colour and the scene has none
    ObjectFinder(const FieldOptions& options, int threshold, const Reference& reference,
                 const Plane<std::uint8_t>& region, bool marks_darker = false);

    /// Whether it adapts: then `find_and_adapt` needs every frame once, in order.
    bool adapts() const { return running_.has_value(); }

    /// \param frame smoothed by the setting
    FoundObject find(const Planes& frame) const;

    /// The same, and then the reference follows the frame. If most of the picture has changed and stays so, or its
    /// colours have come or gone, the reference begins again from the frames after.
    /// \param seconds of the clip
    /// \param turned whether the camera shows another view
    FoundObject find_and_adapt(const Planes& frame, double seconds, bool turned = false);

    /// The reference that follows the frames, smoothed. \pre adapts()
    const Planes& adapted() const { return running_->now(); }

  private:
    void set_scene(const Planes& scene, const Plane<std::uint8_t>& noise);
    FoundObject learn(const Planes& frame, double seconds);
    IlluminationChange light_of(const Planes& frame, const Planes& reference) const;
    FoundObject compare(const Planes& frame, const Planes& reference, const IlluminationChange& light) const;
    FoundObject compare_in_light(const Planes& frame, const Planes& empty) const;
    Plane<std::uint8_t> without_shadows(Plane<std::uint8_t> object, const Planes& frame, const Planes& empty) const;

    const IlluminationRow& illumination_;
    const NormRow& norm_;
    int threshold_;
    int min_area_;
    int least_strong_;              ///< number of pixels of a blob that must reach `strong_`
    std::uint8_t threshold_value_;  ///< value of a difference equal to the threshold; smaller ones are faint
    HoleOptions holes_;
    bool removes_shadows_;
    bool marks_darker_;
    const Plane<std::uint8_t>& region_;
    double looked_at_;  ///< pixels of it
    Planes reference_;
    Plane<std::uint8_t> weak_;    ///< lower hysteresis threshold, as a difference
    Plane<std::uint8_t> strong_;  ///< upper hysteresis threshold, as a value of the object
    std::optional<RunningReference> running_;
    std::optional<double> changed_{};     ///< seconds; when most of the picture changed, until that is learnt
    std::vector<media::Frame> learnt_{};  ///< since then
};

/// Copies the changed part of `object` to `changed`: tiles of 8 × 8 pixels that differ between two frames by more than
/// the camera's noise, and their neighbours. The noise level comes from the quiet tiles of the same frames.
/// \param other, here the frames, smoothed; `object` belongs to `here`
void mark_changes(const Plane<std::uint8_t>& other, const Plane<std::uint8_t>& here, const Plane<std::uint8_t>& object,
                  Plane<std::uint8_t>& changed);

}  // namespace vvr::fields
