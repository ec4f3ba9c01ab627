#include "core/fields/median_scene.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"
#include "core/fields/thresholds.h"

namespace vvr::fields {

// The value is found bit by bit, from the highest. Every loop runs along the row, so the compiler vectorizes it;
// sorting each pixel's values takes 40 times as long.
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
Plane<Pixel> median(std::span<const media::Frame> frames, Plane<Pixel> media::Frame::*plane) {
    Plane<Pixel> result((frames.front().*plane).size());
    oneapi::tbb::parallel_for(0, result.height(), [&](int j) {
        std::vector<const std::uint8_t*> rows(frames.size());
        std::ranges::transform(frames, rows.begin(),
                               [&](const media::Frame& f) { return first_byte((f.*plane).row(j)); });
        rank_rows(rows, (rows.size() + 1) / 2, bytes(result.row(j)));
    });
    return result;
}

}  // namespace

Planes median_reference(std::span<const media::Frame> frames) {
    if (frames.empty()) return {};
    return {median(frames, &media::Frame::grey), median(frames, &media::Frame::colour)};
}

namespace {

bool similar(std::uint8_t a, std::uint8_t b) {
    return std::abs(a - b) <= thresholds.scene.level_tolerance;
}
bool similar(const Bgr& a, const Bgr& b) {
    return similar(a[0], b[0]) && similar(a[1], b[1]) && similar(a[2], b[2]);
}

/// One channel of a pixel in some frames.
template <class Value>
std::uint8_t median_of(std::vector<std::uint8_t>& scratch, const std::vector<const media::Frame*>& frames,
                       Value value) {
    scratch.clear();
    for (const media::Frame* frame : frames) scratch.push_back(value(*frame));
    const auto half = scratch.begin() + std::ssize(scratch) / 2;
    std::ranges::nth_element(scratch, half);
    return *half;
}

/// Sets a pixel of the scene to its median in some frames.
void set_median(Planes& scene, std::size_t i, const std::vector<const media::Frame*>& frames,
                std::vector<std::uint8_t>& scratch) {
    scene.grey.pixels()[i] = median_of(scratch, frames, [i](const media::Frame& f) { return f.grey.pixels()[i]; });
    if (scene.colour.empty()) return;
    for (std::size_t c = 0; c < 3; ++c) {
        scene.colour.pixels()[i][c] =
            median_of(scratch, frames, [i, c](const media::Frame& f) { return f.colour.pixels()[i][c]; });
    }
}

template <class Pixel>
class FirstLasting {
  public:
    FirstLasting(std::span<const media::Frame> frames, Plane<Pixel> media::Frame::*plane)
        : frames_(frames), plane_(plane) {}

    /// Whether more than three quarters of the frames look like `pixel` there: then nothing else can last.
    bool is_stable(std::size_t i, const Pixel& pixel) const { return 4 * count_similar(i, pixel) > 3 * frames_.size(); }

    /// The frames that show the first lasting level; none if there is no such level.
    void find(std::size_t i, std::vector<const media::Frame*>& found) const {
        found.clear();
        for (const media::Frame& first : frames_) {
            const Pixel& pixel = at(first, i);
            if (4 * count_similar(i, pixel) < frames_.size()) continue;
            for (const media::Frame& frame : frames_) {
                if (similar(at(frame, i), pixel)) found.push_back(&frame);
            }
            return;
        }
    }

  private:
    const Pixel& at(const media::Frame& frame, std::size_t i) const { return (frame.*plane_).pixels()[i]; }

    std::size_t count_similar(std::size_t i, const Pixel& pixel) const {
        std::size_t count = 0;
        for (const media::Frame& frame : frames_) count += similar(at(frame, i), pixel) ? 1U : 0U;
        return count;
    }

    std::span<const media::Frame> frames_;
    Plane<Pixel> media::Frame::*plane_;
};

template <class Pixel>
void correct(Planes& reference, std::span<const media::Frame> frames, Plane<Pixel> media::Frame::*plane,
             const Plane<Pixel>& medians) {
    const FirstLasting<Pixel> lasting(frames, plane);
    using oneapi::tbb::blocked_range;
    oneapi::tbb::parallel_for(blocked_range<std::size_t>(0, medians.pixels().size()), [&](const auto& range) {
        std::vector<const media::Frame*> shown;
        std::vector<std::uint8_t> scratch;
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            if (lasting.is_stable(i, medians.pixels()[i])) continue;
            lasting.find(i, shown);
            if (!shown.empty()) set_median(reference, i, shown, scratch);
        }
    });
}

}  // namespace

Planes lasting_reference(std::span<const media::Frame> frames) {
    Planes reference = median_reference(frames);
    const Planes medians = reference;
    if (medians.colour.empty()) {
        correct(reference, frames, &media::Frame::grey, medians.grey);
    } else {
        correct(reference, frames, &media::Frame::colour, medians.colour);
    }
    return reference;
}

namespace {

/// Whether most of the frames show a pixel as it is in the scene.
bool show(const std::vector<const media::Frame*>& frames, const Planes& scene, std::size_t i) {
    const auto count = std::ranges::count_if(frames, [&](const media::Frame* frame) {
        if (scene.colour.empty()) return similar(scene.grey.pixels()[i], frame->grey.pixels()[i]);
        return similar(scene.colour.pixels()[i], frame->colour.pixels()[i]);
    });
    return 2 * count > std::ssize(frames);
}

}  // namespace

void look_behind(std::span<const media::Frame> frames, const LivingFinder& find_living, Planes& scene) {
    const std::size_t step = std::max<std::size_t>(1, frames.size() / thresholds.scene.looks);
    std::vector<const media::Frame*> seen;
    std::vector<Plane<std::uint8_t>> hides;
    for (std::size_t k = 0; k < frames.size(); k += step) {
        const std::vector<PixelBox> boxes = find_living(frames[k]);
        if (k == 0 && boxes.empty()) return;
        seen.push_back(&frames[k]);
        Plane<std::uint8_t>& plane = hides.emplace_back(scene.grey.size());
        for (const PixelBox& living : boxes) fill(plane, living, 1);
    }
    std::vector<const media::Frame*> behind;
    std::vector<const media::Frame*> before;
    std::vector<std::uint8_t> scratch;
    for (std::size_t i = 0; i < scene.grey.pixels().size(); ++i) {
        behind.clear();
        before.clear();
        for (std::size_t k = 0; k < seen.size(); ++k) (hides[k].pixels()[i] != 0 ? before : behind).push_back(seen[k]);
        // The scene shows somebody where it looks like most frames with somebody there, and unlike the others.
        if (behind.size() < thresholds.scene.fewest_behind || !show(before, scene, i) || show(behind, scene, i))
            continue;
        set_median(scene, i, behind, scratch);
    }
}

Plane<std::uint8_t> noise_of(std::span<const media::Frame> frames, const Planes& scene, double smooth, bool shakes) {
    if (frames.size() < thresholds.scene.fewest) return {};
    const std::size_t step = std::max<std::size_t>(1, frames.size() / thresholds.noise.frames);
    std::vector<Plane<std::uint8_t>> differences((frames.size() + step - 1) / step);
    oneapi::tbb::parallel_for(std::size_t{0}, differences.size(), [&](std::size_t k) {
        const media::Frame& frame = frames[k * step];
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
        rank_rows(rows, rank_of(shakes ? thresholds.noise.share_shaking : thresholds.noise.share), row);
        rank_rows(rows, rank_of(thresholds.noise.stable), stable);
        for (std::size_t i = 0; i < row.size(); ++i) {
            row[i] = static_cast<std::uint8_t>(
                std::min<int>(row[i], thresholds.noise.most_ratio * stable[i] + thresholds.noise.most_excess));
        }
    });
    // Leaves that sway here also sway in the next pixel.
    cv::Mat out = cv_view(noise);
    out.convertTo(out, CV_8U, shakes ? thresholds.noise.to_median_shaking : thresholds.noise.to_median);
    cv::blur(out, out, {3, 3});
    cv::dilate(out, out, cv::Mat::ones(3, 3, CV_8U));
    return noise;
}

}  // namespace vvr::fields
