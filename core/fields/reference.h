#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/fields/illumination.h"
#include "core/fields/options.h"
#include "core/fields/planes.h"
#include "core/video/frame.h"
#include "core/video/frame_source.h"

namespace vvr::fields {

/// The empty scene that the difference filter compares with (§4, Fig. 4a).
struct Reference : Planes {
    Reference() = default;
    Reference(Planes scene) : Planes(std::move(scene)) {}

    Plane<std::uint8_t> noise{};  ///< of `noise_of`; empty where too few frames were looked at
    bool shakes = false;          ///< whether the camera does, and nobody asked to leave it so
};

/// One row of the reference table: where the empty scene comes from.
struct ReferenceRow {
    std::string_view name;
    std::string_view help;
    std::vector<video::Frame> (*look)(video::FrameSource& clip);  ///< frames to learn from, in order of time
    Planes (*scene)(std::span<const video::Frame> frames);        ///< what they have in common
    bool needs_whole_clip = false;                                ///< so a stream can't have it
    bool adapts = false;  ///< follows slow changes of the scene from frame to frame
};

/// "median", "first", "running".
std::span<const ReferenceRow> reference_kinds();

/// The empty scene of a clip, after a row of the table or from a picture file, which is brought to the clip's field
/// size. Where changes of light are made up for, so they are here; and frames of a camera that shakes are aligned.
/// Leaves the clip at its first frame.
/// \throws Error io or not_video for a picture that can't be read
Reference make_reference(video::FrameSource& clip, const FieldOptions& options);

/// The median of every pixel over pictures, channel by channel: what was seen in more than half of them. With an
/// even number of pictures it is the upper of the two middle values. All must be of one size; none gives an empty
/// reference.
Planes median_reference(std::span<const video::Frame> frames);

/// The empty scene of pictures in order of time: at each pixel the median of the level that it showed first for at
/// least a quarter of them, and where there is none the median of all. A passer-by is seldom anywhere for that long;
/// and a bag that was left stays an object even when it lies there for most of the clip, which the median of all
/// would take for the scene.
Planes lasting_reference(std::span<const video::Frame> frames);

/// A reference that follows slow changes of the scene for as long as a stream lasts. Where there is an object it
/// waits, so a bag that was left behind is never swallowed. But somebody who stood there while the scene was learnt
/// leaves a ghost when walking away: what has not changed for `ghost_frames`, and has its outline in the reference and
/// not in the frame, is the scene.
class RunningReference {
  public:
    static constexpr int ghost_frames = 125;  ///< five seconds of 25 frames

    explicit RunningReference(const Planes& start);

    const Planes& now() const { return now_; }

    /// Takes in a frame with its difference object. `light` is how the light has changed since the last one: places
    /// behind objects must follow it too.
    void adapt(const Planes& frame, const Plane<std::uint8_t>& object, const IlluminationChange& light);

  private:
    void absorb_ghosts(const Planes& frame, const Plane<std::uint8_t>& object);

    Planes now_;
    int frames_ = 0;
    Plane<std::uint8_t> last_level_;   ///< of each object pixel's grey when it last changed
    Plane<std::uint16_t> steady_for_;  ///< frames since then; 0 where there is no object
    std::vector<float> grey_;
    std::vector<float> colour_;
};

}  // namespace vvr::fields
