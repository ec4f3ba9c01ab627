#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "core/fields/planes.h"
#include "core/media/frame.h"

namespace vvr::fields {

/// One row of the table of stabilizers.
struct StabilizerRow {
    std::string_view name;
    std::string_view help;
    bool aligns;  ///< frames are aligned if the camera shakes
};

/// "auto", "off".
std::span<const StabilizerRow> stabilizers();

/// The shift of a picture, pixels to the right and down.
struct Shift {
    double x = 0;
    double y = 0;
};

/// The area that both a frame and the reference show.
struct VisibleArea {
    int left, right, top, bottom;  ///< columns left to right - 1, rows top to bottom - 1
};

/// Compensates the motion of a shaking camera. Tracks corners of the reference into the frame (pyramidal Lucas-Kanade);
/// the shift on which most of them agree is the camera's, and moving objects are outliers. Only a translation is
/// estimated: a camera on a pole rotates little, and at field size a small rotation looks like a shift.
class Stabilizer {
  public:
    /// \param reference the picture to which frames are aligned
    explicit Stabilizer(const Planes& reference);
    Stabilizer(const Stabilizer&) = delete;
    Stabilizer& operator=(const Stabilizer&) = delete;
    ~Stabilizer();

    /// The shift of the frame from the reference; {0, 0} if too few points agree.
    Shift shift_of(const Plane<std::uint8_t>& grey) const;

    /// Shifts the frame back by `shift`, and fills the uncovered area from the reference.
    /// \returns the area that the frame does show
    VisibleArea align(media::Frame& frame, const Shift& shift) const;

  private:
    struct Landmarks;

    Planes reference_;
    std::unique_ptr<const Landmarks> landmarks_;
};

/// Sets pixels outside the visible area to 0.
void clear_outside_overlap(const VisibleArea& visible, Plane<std::uint8_t>& plane);

/// Whether the camera shakes: it moves by half a pixel or more from the first of the frames to at least two others.
/// \param frames of one scene in the same light; only their grey levels are used
bool camera_shakes(std::span<const media::Frame> frames);

/// Aligns all frames to the median position of the camera.
void align(std::span<media::Frame> frames);

}  // namespace vvr::fields
