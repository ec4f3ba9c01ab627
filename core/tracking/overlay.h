#pragma once

#include <complex>
#include <cstdint>
#include <vector>

#include "core/base/plane.h"
#include "core/base/wall_clock.h"
#include "core/media/frame_source.h"

namespace vvr::tracking {

/// Finds the clock that a camera writes into its pictures, by how it changes: some of its pixels change when a second
/// begins, always at the same phase, and at no other time. Nothing else in a scene does, wherever the clock is.
///
/// It needs at least three frames per second and about twenty seconds: a dozen changes, and it looks every ten seconds.
class ClockFinder {
  public:
    /// \param grey the picture; the search rests while it is empty
    void add(const Plane<std::uint8_t>& grey, const Moment& now);

    /// The boxes of all clocks found so far, in pixels of the picture.
    const std::vector<PixelBox>& found() const { return found_; }

    /// Looks for a last time, after the last picture.
    void finish() {
        if (!before_.empty()) look();
    }

  private:
    /// How a pixel changed in the current window.
    struct Changes {
        std::complex<float> phases;  ///< sum of a unit vector per change
        std::uint16_t count = 0;
        std::uint16_t seconds = 0;  ///< number of seconds with a change
        std::int32_t last = -1;     ///< the last of them
    };

    void look();
    void keep(const PixelBox& box);

    Plane<std::uint8_t> before_;
    Plane<Changes> changes_;
    double last_ = 0;       ///< seconds: time of `before_`
    double begin_ = 0;      ///< seconds: beginning of the window
    double next_look_ = 0;  ///< seconds
    std::vector<PixelBox> found_;
};

/// The clocks in the first minute of a clip, in pixels of its field. Leaves the clip at its first frame. Finds none in
/// a live stream, which can't be read twice.
std::vector<PixelBox> find_clocks(media::FrameSource& clip);

}  // namespace vvr::tracking
