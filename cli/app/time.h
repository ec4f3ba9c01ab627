#pragma once

namespace vvr::app {

/// A place in a clip, or a length of it.
struct Time {
    enum class Unit { frames, seconds };
    double value = 0;
    Unit unit = Unit::frames;

    friend bool operator==(const Time&, const Time&) = default;
};

}  // namespace vvr::app
