#pragma once

#include <cstdint>
#include <functional>
#include <memory>
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

/// The empty scene for background subtraction (§4, Fig. 4a).
struct Reference : Planes {
    Reference() = default;
    Reference(Planes scene) : Planes(std::move(scene)) {}

    const Planes& planes() const { return *this; }

    Plane<std::uint8_t> noise{};  ///< result of `noise_of`; empty if there were too few frames
    bool shakes = false;          ///< the camera shakes, and stabilization is on

    /// The empty scene of the frames without colours, if the camera changes between colour and infrared during the
    /// clip; else null.
    std::shared_ptr<const Reference> infrared{};
};

/// What is known of a scene before the first frame.
struct EmptyScene {
    Reference reference;         ///< may be empty unless `needs_reference`
    Plane<std::uint8_t> region;  ///< 0 = ignored; empty = nothing is ignored
    std::int64_t frames = 0;     ///< frames of the clip; 0 = unknown
};

/// Whether these options need the empty scene: for the filter, or for the seeds' area.
bool needs_reference(const FieldOptions& options);

/// Makes the empty scene of frames that are in order of time.
using SceneOfFrames = Planes (*)(std::span<const video::Frame> frames);

/// One row of the table of references: the source of the empty scene.
struct ReferenceRow {
    std::string_view name;
    std::string_view help;
    std::vector<video::Frame> (*sample)(video::FrameSource& clip);  ///< frames to learn from, in order of time
    SceneOfFrames scene;
    bool needs_whole_clip = false;  ///< not possible for streams
    bool adapts = false;            ///< follows slow changes of the scene
};

/// "median", "first", "running".
std::span<const ReferenceRow> reference_kinds();

/// The boxes of people, vehicles and animals in a frame, field pixels.
using LivingFinder = std::function<std::vector<PixelBox>(const video::Frame&)>;

/// Replaces people, vehicles and animals in the empty scene by what is behind them. Looks at the first frame, and only
/// if somebody is in it, at about seven more. Whoever is at a place in nearly all of them stays in the scene.
/// \param frames from which `scene` was made, in order of time
void look_behind(std::span<const video::Frame> frames, const LivingFinder& find_living, Planes& scene);

/// Makes the empty scene of a clip, by a row of the table or from a picture file (scaled to the field's size). Changes
/// of light are compensated if the options say so; frames of a shaking camera are aligned. If some frames have colours
/// and others none, each kind gives its own scene. Leaves the clip at its first frame.
/// \param find_living may be empty; then whoever stands there for long may be in the scene
/// \throws Error io or not_video for a picture that can't be read
Reference make_reference(video::FrameSource& clip, const FieldOptions& options, const LivingFinder& find_living = {});

/// The median of each pixel and channel over frames: the upper of the two middle values for an even number. All frames
/// must have the same size; without frames the result is empty.
Planes median_reference(std::span<const video::Frame> frames);

/// The empty scene of frames that are ordered by time. Each pixel is the median of the first level that lasts for at
/// least a quarter of the frames, or else the median of all frames. Passers-by seldom stay that long. A bag left behind
/// stays an object even if it lies there for most of the clip; the median of all frames would contain it.
Planes lasting_reference(std::span<const video::Frame> frames);

/// The usual deviation of each pixel from the empty scene, grey levels: camera noise, and more where leaves sway or
/// edges tremble. It is roughly the median deviation, taken from the quarter of the frames that deviate least (from the
/// third if the camera shakes), so that an object that is present most of the time doesn't count; from fewer frames
/// where an object stays even longer.
/// \param frames under the same light and, if the camera shakes, aligned
/// \param scene the empty scene, smoothed by `smooth` as the frames will be
/// \returns empty if there are too few frames
Plane<std::uint8_t> noise_of(std::span<const video::Frame> frames, const Planes& scene, double smooth,
                             bool shakes = false);

/// A reference that follows slow changes of the scene in a stream of any length. It doesn't adapt where there is an
/// object, so a bag left behind never becomes background. If somebody stands in the scene while it is learned and walks
/// away later, a ghost remains: an object that hasn't changed for `ghost_frames` frames, with an edge in the reference
/// and none in the frame. A ghost becomes background.
class RunningReference {
  public:
    static constexpr int ghost_frames = 125;  ///< five seconds at 25 frames per second

    explicit RunningReference(const Planes& start);

    const Planes& now() const { return now_; }

    /// Adapts to a frame.
    /// \param light the change of light since the previous frame; it also applies behind objects
    void adapt(const Planes& frame, const Plane<std::uint8_t>& object, const IlluminationChange& light);

  private:
    void absorb_ghosts(const Planes& frame, const Plane<std::uint8_t>& object);

    Planes now_;
    int frames_ = 0;
    Plane<std::uint8_t> last_level_;   ///< grey level of each object pixel when it last changed
    Plane<std::uint16_t> steady_for_;  ///< number of frames since then; 0 where there is no object
    std::vector<float> grey_;
    std::vector<float> colour_;
};

}  // namespace vvr::fields
