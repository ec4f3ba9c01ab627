#include "core/fields/reference.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_for_each.h>
#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/setting.h"
#include "core/fields/filter.h"
#include "core/fields/flow.h"
#include "core/fields/illumination.h"
#include "core/fields/stabilizer.h"
#include "core/video/scaler.h"

namespace vvr::fields {
namespace {

/// For each column, the largest value that at least `needed` of the rows reach: of n rows, (n + 1) / 2 gives the
/// median. It is found bit by bit, from the highest. Every loop runs along the row, so the compiler vectorizes it;
/// sorting each pixel's values takes 40 times as long.
void rank_rows(std::span<const std::uint8_t* const> rows, std::size_t needed, std::span<std::uint8_t> result) {
    std::vector<std::uint16_t> reached(result.size());
    std::ranges::fill(result, std::uint8_t{0});
    for (int bit = 128; bit != 0; bit /= 2) {
        std::ranges::fill(reached, std::uint16_t{0});
        for (const std::uint8_t* row : rows) {
            for (std::size_t i = 0; i < result.size(); ++i) reached[i] += row[i] >= (result[i] | bit);
        }
        for (std::size_t i = 0; i < result.size(); ++i) {
            if (reached[i] >= needed) result[i] = static_cast<std::uint8_t>(result[i] | bit);
        }
    }
}

std::span<std::uint8_t> bytes(std::span<std::uint8_t> row) {
    return row;
}
std::span<std::uint8_t> bytes(std::span<Bgr> row) {
    return {row.front().data(), row.size() * 3};
}
const std::uint8_t* first_byte(std::span<const std::uint8_t> row) {
    return row.data();
}
const std::uint8_t* first_byte(std::span<const Bgr> row) {
    return row.front().data();
}

template <class Pixel>
Plane<Pixel> median(std::span<const video::Frame> frames, Plane<Pixel> video::Frame::*plane) {
    Plane<Pixel> result((frames.front().*plane).size());
    oneapi::tbb::parallel_for(0, result.height(), [&](int j) {
        std::vector<const std::uint8_t*> rows(frames.size());
        std::ranges::transform(frames, rows.begin(),
                               [&](const video::Frame& f) { return first_byte((f.*plane).row(j)); });
        rank_rows(rows, (rows.size() + 1) / 2, bytes(result.row(j)));
    });
    return result;
}

}  // namespace

Planes median_reference(std::span<const video::Frame> frames) {
    if (frames.empty()) return {};
    return {median(frames, &video::Frame::grey), median(frames, &video::Frame::colour)};
}

namespace {

// Grey levels by which an unchanged pixel may vary over a clip, per channel.
constexpr int level_tolerance = 18;

bool similar(std::uint8_t a, std::uint8_t b) {
    return std::abs(a - b) <= level_tolerance;
}
bool similar(const Bgr& a, const Bgr& b) {
    return similar(a[0], b[0]) && similar(a[1], b[1]) && similar(a[2], b[2]);
}

/// One channel of a pixel in some frames.
template <class Value>
std::uint8_t median_of(std::vector<std::uint8_t>& scratch, const std::vector<const video::Frame*>& frames,
                       Value value) {
    scratch.clear();
    for (const video::Frame* frame : frames) scratch.push_back(value(*frame));
    const auto half = scratch.begin() + std::ssize(scratch) / 2;
    std::ranges::nth_element(scratch, half);
    return *half;
}

/// Sets a pixel of the scene to its median in some frames.
void set_median(Planes& scene, std::size_t i, const std::vector<const video::Frame*>& frames,
                std::vector<std::uint8_t>& scratch) {
    scene.grey.pixels()[i] = median_of(scratch, frames, [i](const video::Frame& f) { return f.grey.pixels()[i]; });
    if (scene.colour.empty()) return;
    for (std::size_t c = 0; c < 3; ++c) {
        scene.colour.pixels()[i][c] =
            median_of(scratch, frames, [i, c](const video::Frame& f) { return f.colour.pixels()[i][c]; });
    }
}

template <class Pixel>
class FirstLasting {
  public:
    FirstLasting(std::span<const video::Frame> frames, Plane<Pixel> video::Frame::*plane)
        : frames_(frames), plane_(plane) {}

    /// Whether more than three quarters of the frames look like `pixel` there: then nothing else can last.
    bool is_stable(std::size_t i, const Pixel& pixel) const { return 4 * count_similar(i, pixel) > 3 * frames_.size(); }

    /// The frames that show the first lasting level; none if there is no such level.
    void find(std::size_t i, std::vector<const video::Frame*>& found) const {
        found.clear();
        for (const video::Frame& first : frames_) {
            const Pixel& pixel = at(first, i);
            if (4 * count_similar(i, pixel) < frames_.size()) continue;
            for (const video::Frame& frame : frames_) {
                if (similar(at(frame, i), pixel)) found.push_back(&frame);
            }
            return;
        }
    }

  private:
    const Pixel& at(const video::Frame& frame, std::size_t i) const { return (frame.*plane_).pixels()[i]; }

    std::size_t count_similar(std::size_t i, const Pixel& pixel) const {
        std::size_t count = 0;
        for (const video::Frame& frame : frames_) count += similar(at(frame, i), pixel) ? 1U : 0U;
        return count;
    }

    std::span<const video::Frame> frames_;
    Plane<Pixel> video::Frame::*plane_;
};

template <class Pixel>
void correct(Planes& reference, std::span<const video::Frame> frames, Plane<Pixel> video::Frame::*plane,
             const Plane<Pixel>& medians) {
    const FirstLasting<Pixel> lasting(frames, plane);
    using oneapi::tbb::blocked_range;
    oneapi::tbb::parallel_for(blocked_range<std::size_t>(0, medians.pixels().size()), [&](const auto& range) {
        std::vector<const video::Frame*> shown;
        std::vector<std::uint8_t> scratch;
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            if (lasting.is_stable(i, medians.pixels()[i])) continue;
            lasting.find(i, shown);
            if (!shown.empty()) set_median(reference, i, shown, scratch);
        }
    });
}

}  // namespace

Planes lasting_reference(std::span<const video::Frame> frames) {
    Planes reference = median_reference(frames);
    const Planes medians = reference;
    if (medians.colour.empty()) {
        correct(reference, frames, &video::Frame::grey, medians.grey);
    } else {
        correct(reference, frames, &video::Frame::colour, medians.colour);
    }
    return reference;
}

namespace {

/// Whether most of the frames show a pixel as it is in the scene.
bool show(const std::vector<const video::Frame*>& frames, const Planes& scene, std::size_t i) {
    const auto count = std::ranges::count_if(frames, [&](const video::Frame* frame) {
        if (scene.colour.empty()) return similar(scene.grey.pixels()[i], frame->grey.pixels()[i]);
        return similar(scene.colour.pixels()[i], frame->colour.pixels()[i]);
    });
    return 2 * count > std::ssize(frames);
}

}  // namespace

void look_behind(std::span<const video::Frame> frames, const LivingFinder& find_living, Planes& scene) {
    constexpr std::size_t looks = 8;
    constexpr std::size_t fewest = 2;  // what a single frame shows may be a shadow or a reflection
    const std::size_t step = std::max<std::size_t>(1, frames.size() / looks);
    std::vector<const video::Frame*> seen;
    std::vector<Plane<std::uint8_t>> hides;
    for (std::size_t k = 0; k < frames.size(); k += step) {
        const std::vector<PixelBox> boxes = find_living(frames[k]);
        if (k == 0 && boxes.empty()) return;
        seen.push_back(&frames[k]);
        Plane<std::uint8_t>& plane = hides.emplace_back(scene.grey.size());
        for (const PixelBox& living : boxes) {
            const PixelBox box = intersection(living, {0, 0, plane.width(), plane.height()});
            for (int j = box.top; j < box.bottom; ++j) {
                for (int i = box.left; i < box.right; ++i) plane.at(i, j) = 1;
            }
        }
    }
    std::vector<const video::Frame*> behind;
    std::vector<const video::Frame*> before;
    std::vector<std::uint8_t> scratch;
    for (std::size_t i = 0; i < scene.grey.pixels().size(); ++i) {
        behind.clear();
        before.clear();
        for (std::size_t k = 0; k < seen.size(); ++k) (hides[k].pixels()[i] != 0 ? before : behind).push_back(seen[k]);
        // The scene shows somebody where it looks like most frames with somebody there, and unlike the others.
        if (behind.size() < fewest || !show(before, scene, i) || show(behind, scene, i)) continue;
        set_median(scene, i, behind, scratch);
    }
}

namespace {

constexpr std::size_t fewest_frames = 8;

// About this many, spread over the clip, are enough.
constexpr std::size_t enough_frames = 10;

/// The share of the frames that counts, and the factor that makes the largest of their differences a median: for
/// Gaussian noise, 0.67 σ / 0.32 σ or 0.67 σ / 0.43 σ.
struct Sample {
    double share;
    double to_median;
};

// Where somebody stands at a counter, the scene may be empty in no more than a quarter of the frames. If the camera
// shakes, edges tremble, but not in each frame: so few frames don't tell.
constexpr Sample still_camera{0.25, 2.1};
constexpr Sample shaking_camera{1.0 / 3, 1.55};

// The share of the frames that show the empty scene even where an object lies for most of the clip. The noise is at
// most this multiple of the noise in these frames, plus some grey levels: larger deviations are the object.
constexpr double stable_share = 0.15;
constexpr int max_ratio = 4;
constexpr int max_excess = 2;

}  // namespace

Plane<std::uint8_t> noise_of(std::span<const video::Frame> frames, const Planes& scene, double smooth, bool shakes) {
    const Sample sample = shakes ? shaking_camera : still_camera;
    if (frames.size() < fewest_frames) return {};
    const std::size_t step = std::max<std::size_t>(1, frames.size() / enough_frames);
    std::vector<Plane<std::uint8_t>> differences((frames.size() + step - 1) / step);
    oneapi::tbb::parallel_for(std::size_t{0}, differences.size(), [&](std::size_t k) {
        const video::Frame& frame = frames[k * step];
        differences[k] = largest_difference(smoothed(frame.grey, frame.colour, smooth), scene);
    });
    const auto rank_of = [&](double part) {
        return differences.size() - static_cast<std::size_t>(part * static_cast<double>(differences.size() - 1));
    };
    Plane<std::uint8_t> noise(scene.grey.size());
    oneapi::tbb::parallel_for(0, noise.height(), [&](int j) {
        std::vector<const std::uint8_t*> rows;
        for (const Plane<std::uint8_t>& plane : differences) rows.push_back(plane.row(j).data());
        const std::span<std::uint8_t> row = noise.row(j);
        std::vector<std::uint8_t> stable(row.size());
        rank_rows(rows, rank_of(sample.share), row);
        rank_rows(rows, rank_of(stable_share), stable);
        for (std::size_t i = 0; i < row.size(); ++i) {
            row[i] = static_cast<std::uint8_t>(std::min<int>(row[i], max_ratio * stable[i] + max_excess));
        }
    });
    // Leaves that sway here also sway in the next pixel.
    cv::Mat out = cv_view(noise);
    out.convertTo(out, CV_8U, sample.to_median);
    cv::blur(out, out, {3, 3});
    cv::dilate(out, out, cv::Mat::ones(3, 3, CV_8U));
    return noise;
}

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
