#include "core/fields/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_for_each.h>
#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/setting.h"
#include "core/fields/filter.h"
#include "core/fields/noise.h"
#include "core/fields/stabilizer.h"
#include "core/video/scaler.h"

namespace vvr::fields {
namespace {

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

// Odd, so that the median is the middle value.
constexpr int frames_for_median = 31;

/// Converts frames to the light of the first: levels of a pixel are comparable only in the same light.
std::vector<video::Frame> in_one_light(std::vector<video::Frame> frames, const IlluminationRow& illumination) {
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

// A live stream can't wait: two seconds at 25 frames per second must do. From a clip, which can be read again, it is
// the first twenty seconds, so that passers-by are absent for most of them.
std::vector<video::Frame> first_seconds(video::FrameSource& clip) {
    const video::VideoInfo& info = clip.info();
    constexpr double seconds = 20;
    const bool is_live = info.duration <= 0 && info.frames <= 0;
    if (is_live) return first_frames(clip, 25, 2);
    const double rate = info.rate > 0 ? info.rate : 25;
    const int step = std::clamp(static_cast<int>(seconds * rate / frames_for_median), 2, 50);
    return first_frames(clip, frames_for_median, step);
}

constexpr std::array rows{
    ReferenceRow{"median", "each pixel's median over the clip, or of what was first where things came to stay",
                 spread_over_clip, lasting_reference, true},
    ReferenceRow{"first", "the first frame", first_frame, median_reference},
    ReferenceRow{"running", "the first seconds, then following slow changes", first_seconds, lasting_reference, false,
                 true},
};

// Learning rate of the reference per frame: it adapts in about four seconds at 25 frames per second.
constexpr float pace = 1.F / 32;

// Pixels around objects where the reference doesn't adapt: objects have soft edges below the threshold.
constexpr int edge = 3;

template <class T>
void follow(std::vector<float>& exact, std::span<const T> frame, std::span<const std::uint8_t> near_object,
            std::size_t channels, const IlluminationChange& light, std::uint8_t* out) {
    const auto gain = static_cast<float>(light.gain);
    const auto offset = static_cast<float>(light.offset);
    const std::uint8_t* const levels = reinterpret_cast<const std::uint8_t*>(frame.data());
    for (std::size_t i = 0; i < exact.size(); ++i) {
        exact[i] = std::clamp(gain * exact[i] + offset, 0.F, 255.F);
        if (near_object[i / channels] == 0) exact[i] += pace * (levels[i] - exact[i]);
        out[i] = static_cast<std::uint8_t>(std::lround(exact[i]));
    }
}

// Grey levels by which a stationary pixel may vary.
constexpr int steady_tolerance = 12;

constexpr int frames_between_looks = 25;

// A ghost's outline is stronger in the reference than in the frame by this ratio, and by a step of this many grey
// levels.
constexpr double clearer = 2;
constexpr double least_step = 8;

/// The largest gradient at and next to each pixel.
cv::Mat steepness(const Plane<std::uint8_t>& grey) {
    cv::Mat steep;
    cv::morphologyEx(cv_view(grey), steep, cv::MORPH_GRADIENT, cv::Mat::ones(3, 3, CV_8U));
    return steep;
}

/// 255 where a blob of `steady` is a ghost, and `edge` pixels around it; empty if there is none.
Plane<std::uint8_t> ghosts_among(const Plane<std::uint8_t>& steady, const Plane<std::uint8_t>& frame,
                                 const Plane<std::uint8_t>& reference) {
    cv::Mat labels, boxes, centres;
    const int count = cv::connectedComponentsWithStats(cv_view(steady), labels, boxes, centres);
    if (count <= 1) return {};
    cv::Mat inner;
    cv::erode(cv_view(steady), inner, cv::Mat::ones(3, 3, CV_8U));
    const cv::Mat here = steepness(frame);
    const cv::Mat there = steepness(reference);
    struct Outline {
        double here = 0, there = 0, pixels = 0;
    };
    std::vector<Outline> outlines(static_cast<std::size_t>(count));
    for (int j = 0; j < labels.rows; ++j) {
        for (int i = 0; i < labels.cols; ++i) {
            const int label = labels.at<int>(j, i);
            if (label == 0 || inner.at<std::uint8_t>(j, i) != 0) continue;
            Outline& outline = outlines[static_cast<std::size_t>(label)];
            outline.here += here.at<std::uint8_t>(j, i);
            outline.there += there.at<std::uint8_t>(j, i);
            outline.pixels += 1;
        }
    }
    Plane<std::uint8_t> ghosts(steady.size());
    bool any = false;
    for (int j = 0; j < labels.rows; ++j) {
        for (int i = 0; i < labels.cols; ++i) {
            const Outline& outline = outlines[static_cast<std::size_t>(labels.at<int>(j, i))];
            if (outline.there < least_step * outline.pixels || outline.there < clearer * outline.here) continue;
            if (labels.at<int>(j, i) == 0) continue;
            ghosts.at(i, j) = 255;
            any = true;
        }
    }
    if (!any) return {};
    cv::Mat out = cv_view(ghosts);
    cv::dilate(out, out, cv::Mat::ones(2 * edge + 1, 2 * edge + 1, CV_8U));
    return ghosts;
}

Reference learnt(video::FrameSource& clip, const ReferenceRow& row, const FieldOptions& options) {
    std::vector<video::Frame> frames = in_one_light(row.look(clip), *options.illumination);
    Reference reference;
    // A filter that shows the video itself or its motion must show the camera's motion too.
    const bool is_compared = options.filter->traits.object;
    const bool aligns = is_compared && options.stabilize->aligns;
    reference.shakes = aligns && camera_shakes(frames);
    if (reference.shakes) align(frames);
    static_cast<Planes&>(reference) = row.scene(frames);
    if (frames.empty()) return reference;
    reference.noise = noise_of(frames, smoothed(reference.grey, reference.colour, options.smooth), options.smooth);
    return reference;
}

}  // namespace

std::span<const ReferenceRow> reference_kinds() {
    return rows;
}

ReferenceChoice::ReferenceChoice(std::string name) : name_(std::move(name)), row_(nullptr) {
    // A file's name is checked only when the file is needed.
    const auto row = std::ranges::find(rows, name_, &ReferenceRow::name);
    if (row != rows.end()) {
        row_ = &*row;
    } else if (name_.find_first_of("./") == std::string::npos && !std::filesystem::exists(name_)) {
        refuse_choice("reference", name_, names_of(rows), ", or the name of a picture");
    }
}

Reference make_reference(video::FrameSource& clip, const FieldOptions& options) {
    if (const ReferenceRow* const row = options.reference.row()) return learnt(clip, *row, options);
    const std::string& picture_file = options.reference.name();
    video::SourceOptions like_clip;
    like_clip.field_size = clip.field_size();
    like_clip.colour = clip.colour();
    check_is_file(picture_file);
    const auto picture = video::open_source(picture_file, like_clip);
    video::Frame frame = video::Scaler(*picture)(*picture->next());
    return Planes{std::move(frame.grey), std::move(frame.colour)};
}

RunningReference::RunningReference(const Planes& start)
    : now_(start),
      last_level_(start.grey.size()),
      steady_for_(start.grey.size()),
      grey_(start.grey.pixels().begin(), start.grey.pixels().end()) {
    for (const Bgr& pixel : start.colour.pixels()) colour_.insert(colour_.end(), pixel.begin(), pixel.end());
}

void RunningReference::adapt(const Planes& frame, const Plane<std::uint8_t>& object, const IlluminationChange& light) {
    absorb_ghosts(frame, object);
    Plane<std::uint8_t> near_object(object.size());
    cv::Mat out = cv_view(near_object);
    cv::dilate(cv_view(object), out, cv::Mat::ones(2 * edge + 1, 2 * edge + 1, CV_8UC1));
    follow<std::uint8_t>(grey_, frame.grey.pixels(), near_object.pixels(), 1, light, now_.grey.pixels().data());
    if (colour_.empty() || frame.colour.empty()) return;
    follow<Bgr>(colour_, frame.colour.pixels(), near_object.pixels(), 3, light, now_.colour.pixels().front().data());
}

void RunningReference::absorb_ghosts(const Planes& frame, const Plane<std::uint8_t>& object) {
    for (std::size_t i = 0; i < object.pixels().size(); ++i) {
        std::uint16_t& steady = steady_for_.pixels()[i];
        std::uint8_t& last = last_level_.pixels()[i];
        const std::uint8_t level = frame.grey.pixels()[i];
        const bool is_same = steady > 0 && std::abs(level - last) <= steady_tolerance;
        if (!is_same) last = level;
        const int count = object.pixels()[i] == 0 ? 0 : is_same ? std::min(steady + 1, 2 * ghost_frames) : 1;
        steady = static_cast<std::uint16_t>(count);
    }
    if (++frames_ % frames_between_looks != 0) return;
    Plane<std::uint8_t> steady(object.size());
    std::ranges::transform(steady_for_.pixels(), steady.pixels().begin(),
                           [](int frames) { return static_cast<std::uint8_t>(frames >= ghost_frames ? 255 : 0); });
    const Plane<std::uint8_t> ghosts = ghosts_among(steady, frame.grey, now_.grey);
    if (ghosts.empty()) return;
    for (std::size_t i = 0; i < grey_.size(); ++i) {
        if (ghosts.pixels()[i] == 0) continue;
        grey_[i] = frame.grey.pixels()[i];
        now_.grey.pixels()[i] = frame.grey.pixels()[i];
        steady_for_.pixels()[i] = 0;
        if (colour_.empty() || frame.colour.empty()) continue;
        now_.colour.pixels()[i] = frame.colour.pixels()[i];
        for (std::size_t c = 0; c < 3; ++c) colour_[3 * i + c] = frame.colour.pixels()[i][c];
    }
}

Planes median_reference(std::span<const video::Frame> frames) {
    if (frames.empty()) return {};
    return {median(frames, &video::Frame::grey), median(frames, &video::Frame::colour)};
}

}  // namespace vvr::fields
