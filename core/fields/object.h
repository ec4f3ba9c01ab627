#pragma once

#include <cstdint>
#include <optional>

#include "core/fields/blobs.h"
#include "core/fields/illumination.h"
#include "core/fields/options.h"
#include "core/fields/planes.h"
#include "core/fields/reference.h"

namespace vvr::fields {

/// The difference object of a frame.
struct FoundObject {
    Plane<std::uint8_t> values;
    Plane<std::uint8_t> darker;  ///< not 0 where the frame is darker than the empty scene; empty unless asked for
};

/// Finds the difference object of §4 (Fig. 4a): what differs from the empty scene by the norm, in any channel by
/// default, by the threshold or more, with what touches it and differs by a little less. Where the scene itself is
/// restless, both are higher. Its value is twice the difference, 255 at most, because people and bags seldom differ by
/// more than half the range.
class ObjectFinder {
  public:
    /// \param reference the empty scene, not smoothed
    /// \param threshold grey levels
    /// \param region where to look; empty = everywhere. Must live as long as the finder.
    /// \param marks_darker whether FoundObject::darker is wanted
    /// \throws Error usage for a norm that needs colour, of a scene without
    ObjectFinder(const FieldOptions& options, int threshold, const Reference& reference,
                 const Plane<std::uint8_t>& region, bool marks_darker = false);

    /// Whether frames must be given in order, each once, by one thread at a time: `find_and_adapt`.
    bool adapts() const { return running_.has_value(); }

    /// \param frame smoothed as options ask
    FoundObject find(const Planes& frame) const;

    /// The same, after which the reference follows the frame.
    FoundObject find_and_adapt(const Planes& frame);

  private:
    IlluminationChange light_of(const Planes& frame, const Planes& reference) const;
    FoundObject compare(const Planes& frame, const Planes& reference, const IlluminationChange& light) const;
    Plane<std::uint8_t> without_shadows(Plane<std::uint8_t> object, const Planes& frame, const Planes& empty) const;

    const IlluminationRow& illumination_;
    const NormRow& norm_;
    int min_area_;
    int least_strong_;              ///< pixels of a blob that must reach `strong_`
    std::uint8_t threshold_value_;  ///< of what differs by the threshold; what is less is faint
    HoleOptions holes_;
    bool removes_shadows_;
    bool marks_darker_;
    const Plane<std::uint8_t>& region_;
    Reference reference_;
    Plane<std::uint8_t> weak_;    ///< differences below it are nothing
    Plane<std::uint8_t> strong_;  ///< values of the object; a blob without any that high is nothing
    std::optional<RunningReference> running_;
};

}  // namespace vvr::fields
