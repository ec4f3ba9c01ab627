#include "core/fields/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_for_each.h>
#include <opencv2/imgproc.hpp>

#include "core/choice.h"
#include "core/cv_view.h"
#include "core/error.h"
#include "core/fields/settings.h"
#include "core/video/scaler.h"

namespace vvr {
namespace {

// Finds the median bit by bit, from the highest: a bit is set when more than half of the values reach it. Every
// loop runs along the row, so the compiler makes vectors of them; sorting each pixel's values takes 40 times as long.
void median_row(std::span<const std::uint8_t* const> rows, std::span<std::uint8_t> median) {
    const auto needed = static_cast<std::uint16_t>((rows.size() + 1) / 2);
    std::vector<std::uint16_t> reached(median.size());
    std::ranges::fill(median, std::uint8_t{0});
    for (int bit = 128; bit != 0; bit /= 2) {
        std::ranges::fill(reached, std::uint16_t{0});
        for (const std::uint8_t* row : rows) {
            for (std::size_t i = 0; i < median.size(); ++i) reached[i] += row[i] >= (median[i] | bit);
        }
        for (std::size_t i = 0; i < median.size(); ++i) {
            if (reached[i] >= needed) median[i] = static_cast<std::uint8_t>(median[i] | bit);
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
Plane<Pixel> median(std::span<const Frame> frames, Plane<Pixel> Frame::*plane) {
    Plane<Pixel> result((frames.front().*plane).size());
    oneapi::tbb::parallel_for(0, result.height(), [&](int j) {
        std::vector<const std::uint8_t*> rows(frames.size());
        std::ranges::transform(frames, rows.begin(), [&](const Frame& f) { return first_byte((f.*plane).row(j)); });
        median_row(rows, bytes(result.row(j)));
    });
    return result;
}

// An odd number, so that the median is the middle value.
constexpr int frames_for_median = 31;

/// Frames brought to the light of the first: levels of one pixel can be compared only in one light.
std::vector<Frame> in_one_light(std::vector<Frame> frames, const IlluminationRow& illumination) {
    if (!illumination.compensates || frames.empty()) return frames;
    const Planes first{frames.front().grey, frames.front().colour};
    oneapi::tbb::parallel_for_each(frames, [&](Frame& frame) {
        Planes picture{std::move(frame.grey), std::move(frame.colour)};
        picture = in_light(picture, light_between(picture, first));
        frame.grey = std::move(picture.grey);
        frame.colour = std::move(picture.colour);
    });
    return frames;
}

Reference median_of_clip(FrameSource& clip, const IlluminationRow& illumination) {
    return lasting_reference(in_one_light(clip.sample(frames_for_median), illumination));
}

/// The clip's first frames, every `step`-th.
std::vector<Frame> first_frames(FrameSource& clip, int count, int step) {
    Scaler scale(clip);
    std::vector<Frame> frames;
    clip.rewind();
    for (int f = 0; f < count * step; ++f) {
        const std::unique_ptr<DecodedFrame> decoded = clip.next();
        if (!decoded) break;
        if (f % step == 0) frames.push_back(scale(*decoded));
    }
    clip.rewind();
    return frames;
}

Reference first_frame(FrameSource& clip, const IlluminationRow&) {
    return median_reference(first_frames(clip, 1, 1));
}

// A stream can't be looked at to its end: two seconds of 25 frames must do to begin with.
Reference first_seconds(FrameSource& clip, const IlluminationRow& illumination) {
    return median_reference(in_one_light(first_frames(clip, 25, 2), illumination));
}

constexpr std::array rows{
    ReferenceRow{"median", "each pixel's median over the clip, or of what was first where things came to stay",
                 median_of_clip, true},
    ReferenceRow{"first", "the first frame", first_frame},
    ReferenceRow{"running", "the first seconds, then following slow changes", first_seconds, false, true},
};

// How far the reference moves toward a frame: settled after some four seconds of 25 frames.
constexpr float pace = 1.F / 32;

// Objects have soft edges that are below the threshold; the reference stays away from them.
constexpr int edge = 3;

template <class T>
void follow(std::vector<float>& exact, std::span<const T> frame, std::span<const std::uint8_t> near_object,
            std::size_t channels, const Light& light, std::uint8_t* out) {
    const auto gain = static_cast<float>(light.gain);
    const auto offset = static_cast<float>(light.offset);
    const std::uint8_t* const levels = reinterpret_cast<const std::uint8_t*>(frame.data());
    for (std::size_t i = 0; i < exact.size(); ++i) {
        exact[i] = std::clamp(gain * exact[i] + offset, 0.F, 255.F);
        if (near_object[i / channels] == 0) exact[i] += pace * (levels[i] - exact[i]);
        out[i] = static_cast<std::uint8_t>(std::lround(exact[i]));
    }
}

}  // namespace

std::span<const ReferenceRow> reference_kinds() {
    return rows;
}

const ReferenceRow* find_reference(std::string_view name) {
    const auto row = std::ranges::find(rows, name, &ReferenceRow::name);
    return row == rows.end() ? nullptr : &*row;
}

void validate_reference(const std::string& kind) {
    // Whatever could be a file's name is looked for when it is needed.
    if (kind.find_first_of("./") == std::string::npos && !std::filesystem::exists(kind)) {
        choose(setting::reference.name, kind, rows, ", or the name of a picture");
    }
}

Reference make_reference(FrameSource& clip, const FieldOptions& options) {
    const std::string& kind = options.reference;
    validate_reference(kind);
    if (const ReferenceRow* const row = find_reference(kind)) {
        return row->make(clip, choose(setting::illumination.name, options.illumination, illuminations()));
    }
    SourceOptions like_clip;
    like_clip.field_size = clip.field_size();
    like_clip.colour = clip.colour();
    const auto picture = open_source(kind, like_clip);
    Frame frame = Scaler(*picture)(*picture->next());
    return {std::move(frame.grey), std::move(frame.colour)};
}

RunningReference::RunningReference(const Reference& start)
    : now_(start), grey_(start.grey.pixels().begin(), start.grey.pixels().end()) {
    for (const Bgr& pixel : start.colour.pixels()) colour_.insert(colour_.end(), pixel.begin(), pixel.end());
}

void RunningReference::adapt(const Planes& frame, const Plane<std::uint8_t>& object, const Light& light) {
    Plane<std::uint8_t> near_object(object.size());
    cv::Mat out = cv_view(near_object);
    cv::dilate(cv_view(object), out, cv::Mat::ones(2 * edge + 1, 2 * edge + 1, CV_8UC1));
    follow<std::uint8_t>(grey_, frame.grey.pixels(), near_object.pixels(), 1, light, now_.grey.pixels().data());
    if (colour_.empty() || frame.colour.empty()) return;
    follow<Bgr>(colour_, frame.colour.pixels(), near_object.pixels(), 3, light, now_.colour.pixels().front().data());
}

Reference median_reference(std::span<const Frame> frames) {
    if (frames.empty()) return {};
    return {median(frames, &Frame::grey), median(frames, &Frame::colour)};
}

}  // namespace vvr
