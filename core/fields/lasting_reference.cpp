#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <vector>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include "core/fields/reference.h"

namespace vvr::fields {
namespace {

// Grey levels by which an unchanged pixel may vary over a clip, per channel.
constexpr int tolerance = 18;

bool alike(std::uint8_t a, std::uint8_t b) {
    return std::abs(a - b) <= tolerance;
}
bool alike(const Bgr& a, const Bgr& b) {
    return alike(a[0], b[0]) && alike(a[1], b[1]) && alike(a[2], b[2]);
}

/// One channel of a pixel in some frames.
template <class Value>
std::uint8_t middle(std::vector<std::uint8_t>& scratch, const std::vector<const video::Frame*>& frames, Value value) {
    scratch.clear();
    for (const video::Frame* frame : frames) scratch.push_back(value(*frame));
    const auto half = scratch.begin() + std::ssize(scratch) / 2;
    std::ranges::nth_element(scratch, half);
    return *half;
}

template <class Pixel>
class FirstLasting {
  public:
    FirstLasting(std::span<const video::Frame> frames, Plane<Pixel> video::Frame::*plane)
        : frames_(frames), plane_(plane) {}

    /// Whether more than three quarters of the frames look like `pixel` there: then nothing else can last.
    bool is_sure(std::size_t i, const Pixel& pixel) const { return 4 * like(i, pixel) > 3 * frames_.size(); }

    /// The frames that show the first lasting level; none if there is no such level.
    void find(std::size_t i, std::vector<const video::Frame*>& found) const {
        found.clear();
        for (const video::Frame& first : frames_) {
            const Pixel& pixel = at(first, i);
            if (4 * like(i, pixel) < frames_.size()) continue;
            for (const video::Frame& frame : frames_) {
                if (alike(at(frame, i), pixel)) found.push_back(&frame);
            }
            return;
        }
    }

  private:
    const Pixel& at(const video::Frame& frame, std::size_t i) const { return (frame.*plane_).pixels()[i]; }

    std::size_t like(std::size_t i, const Pixel& pixel) const {
        std::size_t count = 0;
        for (const video::Frame& frame : frames_) count += alike(at(frame, i), pixel) ? 1U : 0U;
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
            if (lasting.is_sure(i, medians.pixels()[i])) continue;
            lasting.find(i, shown);
            if (shown.empty()) continue;
            reference.grey.pixels()[i] =
                middle(scratch, shown, [i](const video::Frame& f) { return f.grey.pixels()[i]; });
            if (reference.colour.empty()) continue;
            for (std::size_t c = 0; c < 3; ++c) {
                reference.colour.pixels()[i][c] =
                    middle(scratch, shown, [i, c](const video::Frame& f) { return f.colour.pixels()[i][c]; });
            }
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

}  // namespace vvr::fields
