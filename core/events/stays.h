#pragma once

#include <optional>
#include <vector>

#include "core/events/event.h"

namespace vvr::events {

/// Finds the times for which something that need not be quite still, as a person who waits, kept its place.
class Stays {
  public:
    /// \param least seconds that make a stay
    explicit Stays(double least) : least_(least) {}

    /// \param reach field pixels by which the middle may be off its first place
    void add(const Moment& now, const glm::dvec2& place, const PixelBox& box, double reach);

    /// Takes the place of what was found for that time.
    void add_exactly(const Stay& stay);

    /// What has not come to its end.
    const std::optional<Stay>& open() const { return open_; }

    /// All of them, in order.
    std::vector<Stay> finish();

  private:
    void close();

    double least_;
    std::optional<Stay> open_;
    std::vector<Stay> found_;
};

}  // namespace vvr::events
