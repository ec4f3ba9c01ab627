#include "core/fields/reference.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

#include <oneapi/tbb/parallel_for_each.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/setting.h"
#include "core/fields/filter.h"
#include "core/fields/flow.h"
#include "core/fields/illumination.h"
#include "core/fields/median_scene.h"
#include "core/fields/stabilizer.h"
#include "core/fields/thresholds.h"
#include "core/fields/views.h"
#include "core/footage/open_source.h"
#include "core/media/scaler.h"

namespace vvr::fields {

namespace {

/// Converts frames to the light of the first: levels of a pixel are comparable only in the same light.
std::vector<media::Frame> relit_like_first(std::vector<media::Frame> frames, const IlluminationRow& illumination) {
    if (!illumination.compensates || frames.empty()) return frames;
    const Planes first{frames.front().grey, frames.front().colour};
    oneapi::tbb::parallel_for_each(frames, [&](media::Frame& frame) {
        Planes picture{std::move(frame.grey), std::move(frame.colour)};
        picture = relight(picture, estimate_illumination(picture, first));
        frame.grey = std::move(picture.grey);
        frame.colour = std::move(picture.colour);
    });
    return frames;
}

/// The grey levels of some of the frames, which tell whether the camera shakes.
std::vector<media::Frame> frames_for_shake(std::span<const media::Frame> frames) {
    const std::size_t count = std::min(frames.size(), thresholds.shake.frames);
    std::vector<media::Frame> some(count);
    for (std::size_t k = 0; k < count; ++k) some[k].grey = frames[k * frames.size() / count].grey;
    return some;
}

std::vector<media::Frame> spread_over_clip(media::FrameSource& clip) {
    return clip.sample(thresholds.scene.frames);
}

/// Frames from the clip's start.
/// \param seconds of the clip that are read
/// \param step seconds between the frames, at least
/// \param fewest frames, also if that takes longer
std::vector<media::Frame> first_frames(media::FrameSource& clip, double seconds, double step, std::size_t fewest) {
    constexpr double slack = 0.001;  // containers round times
    media::Scaler scale(clip);
    std::vector<media::Frame> frames;
    std::optional<double> first;
    double before = 0;
    clip.rewind();
    for (double passed = 0; frames.size() < fewest || passed + (passed - before) < seconds - slack;) {
        const std::unique_ptr<media::DecodedFrame> decoded = clip.next();
        if (!decoded) break;
        if (!first) first = decoded->pts;
        before = std::exchange(passed, decoded->pts - *first);
        const bool is_due = passed >= static_cast<double>(frames.size()) * step - slack;
        if (is_due) frames.push_back(scale(*decoded));
    }
    clip.rewind();
    return frames;
}

std::vector<media::Frame> first_frame(media::FrameSource& clip) {
    return first_frames(clip, 0, 0, 1);
}

std::vector<media::Frame> first_seconds(media::FrameSource& clip) {
    const bool is_live = clip.info().duration <= 0 && clip.info().frames <= 0;
    constexpr auto& scene = thresholds.scene;
    return is_live ? first_frames(clip, scene.live, scene.live_step, scene.fewest)
                   : first_frames(clip, scene.frames * scene.step, scene.step, scene.fewest);
}

constexpr std::array reference_rows{
    ReferenceRow{"median",
                 "the median of the clip; where something came to stay, the median of what was there before, if that "
                 "lasted for a quarter of the clip",
                 spread_over_clip, lasting_reference, true},
    ReferenceRow{"first", "the first frame", first_frame, median_reference},
    ReferenceRow{"running", "learned from the first seconds, then adapted to slow changes", first_seconds,
                 lasting_reference, false, true},
};

Reference learn_from(std::vector<media::Frame> frames, const SceneOfFrames scene, const FieldOptions& options,
                     const LivingFinder& find_living) {
    Reference reference;
    // A filter that shows the video itself or its motion must show the camera's motion too.
    const bool is_compared = options.filter->traits.object;
    const bool aligns = is_compared && options.stabilize->aligns;
    reference.shakes = aligns && camera_shakes(relit_like_first(frames_for_shake(frames), *options.illumination));
    // Before the light is compared: of pixels that show different places, it would seem to have lost contrast.
    if (reference.shakes) align(frames);
    frames = relit_like_first(std::move(frames), *options.illumination);
    static_cast<Planes&>(reference) = scene(frames);
    if (frames.empty()) return reference;
    reference.is_view = is_view_of(reference.grey, frames);
    if (find_living) look_behind(frames, find_living, reference);
    reference.noise =
        noise_of(frames, smoothed(reference.grey, reference.colour, options.smooth), options.smooth, reference.shakes);
    return reference;
}

Reference learn(media::FrameSource& clip, const ReferenceRow& row, const FieldOptions& options,
                const LivingFinder& find_living) {
    std::vector<media::Frame> frames = row.sample(clip);
    const bool can_compare = !row.adapts && options.filter->traits.object && options.illumination->compensates;
    if (!can_compare) return learn_from(std::move(frames), row.scene, options, find_living);
    std::vector<std::vector<media::Frame>> views = by_view(std::move(frames));
    const bool has_colour =
        std::ranges::any_of(views, [](const auto& view) { return has_colours_everywhere(view.front().colour); });
    Reference reference;
    for (std::vector<media::Frame>& of_view : views) {
        const bool infrared = has_colour && shows_infrared(of_view.front());
        const bool is_only = views.size() == 1;
        const SceneOfFrames scene = !is_only && of_view.size() < thresholds.scene.fewest ? median_reference : row.scene;
        Reference learnt = learn_from(std::move(of_view), scene, options, find_living);
        learnt.infrared = infrared && !is_only;
        if (reference.empty()) {
            reference = std::move(learnt);
        } else {
            reference.others.push_back(std::move(learnt));
        }
    }
    return reference;
}

}  // namespace

bool needs_reference(const FieldOptions& options) {
    const FilterTraits& traits = options.filter->traits;
    const bool second = options.second != nullptr && options.second->traits.object;
    return second || traits.object || (has_flow(options.flow) && !traits.shows_object);
}

std::span<const ReferenceRow> reference_kinds() {
    return reference_rows;
}

ReferenceChoice::ReferenceChoice(std::string name) : name_(std::move(name)), row_(nullptr) {
    // A file's name is checked only when the file is needed.
    const auto row = std::ranges::find(reference_rows, name_, &ReferenceRow::name);
    if (row != reference_rows.end()) {
        row_ = &*row;
    } else if (name_.find_first_of("./") == std::string::npos && !std::filesystem::exists(name_)) {
        refuse_choice("reference", name_, names_of(reference_rows), ", or the name of a picture");
    }
}

Reference make_reference(media::FrameSource& clip, const FieldOptions& options, const LivingFinder& find_living) {
    if (const ReferenceRow* const row = options.reference.row()) return learn(clip, *row, options, find_living);
    const std::string& picture_file = options.reference.name();
    media::SourceOptions like_clip;
    like_clip.field_size = clip.field_size();
    like_clip.colour = clip.colour();
    check_is_file(picture_file);
    const auto picture = footage::open_source(picture_file, like_clip);
    media::Frame frame = media::Scaler(*picture)(*picture->next());
    return Planes{std::move(frame.grey), std::move(frame.colour)};
}

}  // namespace vvr::fields
