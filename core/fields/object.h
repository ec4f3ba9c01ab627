#pragma once

#include <cstdint>
#include <optional>

#include "core/fields/clean.h"
#include "core/fields/illumination.h"
#include "core/fields/options.h"
#include "core/fields/reference.h"

namespace vvr {

/// Finds the difference object of §4 (Fig. 4a): what differs from the empty scene in any channel, by the threshold or
/// more. Its value is twice the difference, 255 at most, because people and bags seldom differ by more than half the
/// range.
class ObjectFinder {
  public:
    /// \param reference the empty scene, not smoothed
    /// \param threshold grey levels
    /// \param region where to look; empty = everywhere. Must live as long as the finder.
    ObjectFinder(const FieldOptions& options, int threshold, const Reference& reference,
                 const Plane<std::uint8_t>& region);

    /// Whether frames must be given in order, each once, by one thread at a time: `find_and_adapt`.
    bool adapts() const { return running_.has_value(); }

    /// \param frame smoothed as options ask
    Plane<std::uint8_t> find(const Planes& frame) const;

    /// The same, after which the reference follows the frame.
    Plane<std::uint8_t> find_and_adapt(const Planes& frame);

  private:
    Light light_of(const Planes& frame, const Reference& reference) const;
    Plane<std::uint8_t> compare(const Planes& frame, const Reference& reference, const Light& light) const;

    const IlluminationRow& illumination_;
    CleanOptions clean_;
    int min_area_;
    bool shadows_;
    const Plane<std::uint8_t>& region_;
    Reference reference_;
    std::optional<RunningReference> running_;
};

}  // namespace vvr
