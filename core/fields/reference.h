#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/fields/illumination.h"
#include "core/fields/options.h"
#include "core/fields/planes.h"
#include "core/video/frame.h"
#include "core/video/frame_source.h"

namespace vvr {

/// The empty scene that the difference filter compares with (§4, Fig. 4a).
using Reference = Planes;

/// One row of the reference table: where the empty scene comes from.
struct ReferenceRow {
    std::string_view name;
    std::string_view help;
    Reference (*make)(FrameSource& clip, const IlluminationRow& illumination);
    bool needs_whole_clip = false;  ///< so a stream can't have it
    bool adapts = false;            ///< follows slow changes of the scene from frame to frame
};

/// "median", "first", "running".
std::span<const ReferenceRow> reference_kinds();

/// The row of that name; null for a picture file.
const ReferenceRow* find_reference(std::string_view name);

/// The empty scene of a clip, after a row of the table or from a picture file, which is brought to the clip's field
/// size. Where changes of light are made up for, so they are here. Leaves the clip at its first frame.
/// \throws Error as validate_reference; io or not_video for a picture that can't be read
Reference make_reference(FrameSource& clip, const FieldOptions& options);

/// \throws Error usage for what is neither in the table nor the name of a file
void validate_reference(const std::string& kind);

/// The median of every pixel over pictures, channel by channel: what was seen in more than half of them. With an
/// even number of pictures it is the upper of the two middle values. All must be of one size; none gives an empty
/// reference.
Reference median_reference(std::span<const Frame> frames);

/// The empty scene of pictures in order of time: at each pixel the median of the level that it showed first for at
/// least a quarter of them, and where there is none the median of all. A passer-by is seldom anywhere for that long;
/// and a bag that was left stays an object even when it lies there for most of the clip, which the median of all
/// would take for the scene.
Reference lasting_reference(std::span<const Frame> frames);

/// A reference that follows slow changes of the scene for as long as a stream lasts. Where there is an object it
/// waits, so a bag that was left behind is never swallowed.
class RunningReference {
  public:
    explicit RunningReference(const Reference& start);

    const Reference& now() const { return now_; }

    /// Takes in a frame with its difference object. `light` is how the light has changed since the last one: places
    /// behind objects must follow it too.
    void adapt(const Planes& frame, const Plane<std::uint8_t>& object, const Light& light);

  private:
    Reference now_;
    std::vector<float> grey_;
    std::vector<float> colour_;
};

}  // namespace vvr
