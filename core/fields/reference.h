#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/condition/edge_map.h"
#include "core/fields/median_scene.h"
#include "core/fields/options.h"
#include "core/fields/planes.h"
#include "core/media/frame.h"
#include "core/media/frame_source.h"

namespace vvr::fields {

/// The empty scene for background subtraction (§4, Fig. 4a).
struct Reference : Planes {
    Reference() = default;
    Reference(Planes scene) : Planes(std::move(scene)) {}

    const Planes& planes() const { return *this; }

    Plane<std::uint8_t> noise{};  ///< result of `noise_of`; empty if there were too few frames
    bool shakes = false;          ///< the camera shakes, and stabilization is on
    bool is_view = true;          ///< the camera showed it; one that never keeps still has no view
    bool infrared = false;        ///< of the camera's infrared mode, while others are in colour

    /// The empty scenes of the camera's other views, by the number of frames from which they were learnt: it was moved,
    /// or it changes between colour and infrared.
    std::vector<Reference> others{};

    /// The scene of a view: 0 is this one.
    const Reference& of_view(std::size_t view) const { return view == 0 ? *this : others.at(view - 1); }
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
using SceneOfFrames = Planes (*)(std::span<const media::Frame> frames);

/// One row of the table of references: the source of the empty scene.
struct ReferenceRow {
    std::string_view name;
    std::string_view help;
    std::vector<media::Frame> (*sample)(media::FrameSource& clip);  ///< frames to learn from, in order of time
    SceneOfFrames scene;
    bool needs_whole_clip = false;  ///< not possible for streams
    bool adapts = false;            ///< follows slow changes of the scene
};

/// "median", "first", "running".
std::span<const ReferenceRow> reference_kinds();

/// Makes the empty scene of a clip, by a row of the table or from a picture file (scaled to the field's size). Changes
/// of light are compensated if the options say so; frames of a shaking camera are aligned. If some frames have colours
/// and others none, each kind gives its own scene. Leaves the clip at its first frame.
/// \param find_living may be empty; then whoever stands there for long may be in the scene
/// \throws Error io or not_video for a picture that can't be read
Reference make_reference(media::FrameSource& clip, const FieldOptions& options, const LivingFinder& find_living = {});

}  // namespace vvr::fields
