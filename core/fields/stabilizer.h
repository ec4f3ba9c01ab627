#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "core/fields/planes.h"
#include "core/video/frame.h"

namespace vvr::fields {

/// One row of the table of stabilizers.
struct StabilizerRow {
    std::string_view name;
    std::string_view help;
    bool aligns;  ///< where the camera shakes
};

/// "auto", "off".
std::span<const StabilizerRow> stabilizers();

/// How far a picture has moved, in pixels to the right and down.
struct Shift {
    double x = 0;
    double y = 0;
};

/// The part of a picture that both it and the reference show.
struct VisibleArea {
    int left, right, top, bottom;  ///< columns left to right - 1, rows top to bottom - 1
};

/// Takes the motion of a shaking camera out of frames: points of the reference picture that can be recognised are
/// looked for in the frame (pyramidal Lucas-Kanade), and the shift on which most of them agree is the camera's. What
/// moves by itself disagrees. A shift is all that is measured: a camera on a pole turns by little, and at field size a
/// small turn of it is a shift.
class Stabilizer {
  public:
    /// \param reference the picture that frames are aligned with
    explicit Stabilizer(const Planes& reference);
    Stabilizer(const Stabilizer&) = delete;
    Stabilizer& operator=(const Stabilizer&) = delete;
    ~Stabilizer();

    /// How far the camera's picture has moved since the reference; {0, 0} where too few points agree.
    Shift shift_of(const Plane<std::uint8_t>& grey) const;

    /// Moves the frame back by `shift`. Where it shows nothing it becomes the reference.
    /// \returns what the frame did show
    VisibleArea align(video::Frame& frame, const Shift& shift) const;

  private:
    struct Landmarks;

    Planes reference_;
    std::unique_ptr<const Landmarks> landmarks_;
};

/// Sets to 0 what lies beside the part that is seen.
void clear_outside_overlap(const VisibleArea& visible, Plane<std::uint8_t>& plane);

/// Whether the camera moves by half a pixel or more between frames of one scene, most of the time or now and then.
bool camera_shakes(std::span<const video::Frame> frames);

/// Moves all frames to where the camera looks in the middle of its motion.
void align(std::span<video::Frame> frames);

}  // namespace vvr::fields
