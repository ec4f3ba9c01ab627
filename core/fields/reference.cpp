#include "core/fields/reference.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>

#include <oneapi/tbb/parallel_for_each.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/setting.h"
#include "core/fields/filter.h"
#include "core/fields/flow.h"
#include "core/fields/illumination.h"
#include "core/fields/scene_noise.h"
#include "core/fields/stabilizer.h"
#include "core/video/scaler.h"

namespace vvr::fields {

namespace {

// Odd, so that the median is the middle value.
constexpr int frames_for_median = 31;

/// Converts frames to the light of the first: levels of a pixel are comparable only in the same light.
std::vector<video::Frame> relit_like_first(std::vector<video::Frame> frames, const IlluminationRow& illumination) {
    if (!illumination.compensates || frames.empty()) return frames;
    const Planes first{frames.front().grey, frames.front().colour};
    oneapi::tbb::parallel_for_each(frames, [&](video::Frame& frame) {
        Planes picture{std::move(frame.grey), std::move(frame.colour)};
        picture = relight(picture, estimate_illumination(picture, first));
        frame.grey = std::move(picture.grey);
        frame.colour = std::move(picture.colour);
    });
    return frames;
}

/// The grey levels of seven of the frames, which tell whether the camera shakes.
std::vector<video::Frame> frames_for_shake(std::span<const video::Frame> frames) {
    const std::size_t count = std::min<std::size_t>(frames.size(), 7);
    std::vector<video::Frame> some(count);
    for (std::size_t k = 0; k < count; ++k) some[k].grey = frames[k * frames.size() / count].grey;
    return some;
}

std::vector<video::Frame> spread_over_clip(video::FrameSource& clip) {
    return clip.sample(frames_for_median);
}

/// Every `step`-th frame from the clip's start.
std::vector<video::Frame> first_frames(video::FrameSource& clip, int count, int step) {
    video::Scaler scale(clip);
    std::vector<video::Frame> frames;
    clip.rewind();
    for (int f = 0; f < count * step; ++f) {
        const std::unique_ptr<video::DecodedFrame> decoded = clip.next();
        if (!decoded) break;
        if (f % step == 0) frames.push_back(scale(*decoded));
    }
    clip.rewind();
    return frames;
}

std::vector<video::Frame> first_frame(video::FrameSource& clip) {
    return first_frames(clip, 1, 1);
}

// A live stream can't wait, so two seconds at 25 frames per second must be enough. A clip can be read again, so its
// first twenty seconds are used: passers-by are absent for most of them.
std::vector<video::Frame> first_seconds(video::FrameSource& clip) {
    const video::VideoInfo& info = clip.info();
    constexpr double seconds = 20;
    const bool is_live = info.duration <= 0 && info.frames <= 0;
    if (is_live) return first_frames(clip, 25, 2);
    const double rate = info.rate > 0 ? info.rate : 25;
    const int step = std::clamp(static_cast<int>(seconds * rate / frames_for_median), 2, 50);
    return first_frames(clip, frames_for_median, step);
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

// A scene of fewer frames would hold whoever passes in one of them.
constexpr std::ptrdiff_t fewest_of_mode = 3;

// A quarter of fewer frames is one frame, which doesn't show what lasts.
constexpr std::size_t fewest_for_lasting = 8;

// Grey levels between the darkest and the brightest twentieth of a picture; with less, the camera is covered.
constexpr float least_contrast = 20;

bool is_infrared(const video::Frame& frame) {
    if (has_colours(frame.colour)) return false;
    const Quantiles levels = quantiles_of(frame.grey);
    return levels.back() - levels.front() >= least_contrast;
}

/// Takes the frames out that a camera made in its infrared mode. Takes none if there are too few of these or of others.
std::vector<video::Frame> take_infrared(std::vector<video::Frame>& frames) {
    const auto by_day = [](const video::Frame& frame) { return has_colours_everywhere(frame.colour); };
    if (std::ranges::count_if(frames, is_infrared) < fewest_of_mode) return {};
    if (std::ranges::count_if(frames, by_day) < fewest_of_mode) return {};
    const auto infrared = std::stable_partition(frames.begin(), frames.end(), std::not_fn(is_infrared));
    std::vector<video::Frame> taken(std::make_move_iterator(infrared), std::make_move_iterator(frames.end()));
    frames.erase(infrared, frames.end());
    return taken;
}

Reference learn_from(std::vector<video::Frame> frames, const SceneOfFrames scene, const FieldOptions& options,
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
    if (find_living) look_behind(frames, find_living, reference);
    reference.noise =
        noise_of(frames, smoothed(reference.grey, reference.colour, options.smooth), options.smooth, reference.shakes);
    return reference;
}

Reference learn(video::FrameSource& clip, const ReferenceRow& row, const FieldOptions& options,
                const LivingFinder& find_living) {
    std::vector<video::Frame> frames = row.sample(clip);
    std::vector<video::Frame> infrared;
    if (!row.adapts && options.illumination->compensates) infrared = take_infrared(frames);
    if (infrared.empty()) return learn_from(std::move(frames), row.scene, options, find_living);
    const auto learn_mode = [&](std::vector<video::Frame> of_mode) {
        const SceneOfFrames scene = of_mode.size() < fewest_for_lasting ? median_reference : row.scene;
        return learn_from(std::move(of_mode), scene, options, find_living);
    };
    Reference reference = learn_mode(std::move(frames));
    reference.infrared = std::make_shared<const Reference>(learn_mode(std::move(infrared)));
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

Reference make_reference(video::FrameSource& clip, const FieldOptions& options, const LivingFinder& find_living) {
    if (const ReferenceRow* const row = options.reference.row()) return learn(clip, *row, options, find_living);
    const std::string& picture_file = options.reference.name();
    video::SourceOptions like_clip;
    like_clip.field_size = clip.field_size();
    like_clip.colour = clip.colour();
    check_is_file(picture_file);
    const auto picture = video::open_source(picture_file, like_clip);
    video::Frame frame = video::Scaler(*picture)(*picture->next());
    return Planes{std::move(frame.grey), std::move(frame.colour)};
}

}  // namespace vvr::fields
