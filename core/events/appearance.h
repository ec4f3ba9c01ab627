#pragma once

#include <array>

#include "core/events/patch.h"
#include "core/events/sight.h"

namespace vvr::events {

/// What an object looks like: histograms of brightness and colour of its upper, middle and lower part. A person's coat
/// and trousers are told apart by it, whichever way the person turns.
class Appearance {
  public:
    Appearance() = default;
    Appearance(const Patch& patch, const FrameView& sight);

    /// Takes in another look at the same object. Early looks count more, late ones still follow the light.
    void learn(const Appearance& look);

    bool known() const { return looks_ > 0; }

    /// Hellinger's distance, the mean over parts and channels: 0 = the same, 1 = nothing in common.
    friend double distance(const Appearance& a, const Appearance& b);

  private:
    static constexpr int parts = 3;
    static constexpr int channels = 3;
    static constexpr int bins = 8;

    std::array<float, static_cast<std::size_t>(parts* channels* bins)> histogram_{};
    int looks_ = 0;
};

double distance(const Appearance& a, const Appearance& b);

}  // namespace vvr::events
