#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/image/codec.h"
#include "core/image/picture.h"

namespace vvr::image {

/// The differences that two pictures may have and still count as the same. Values are 0..1, as in the files.
struct Tolerance {
    double level = 0.02;  ///< a pixel is off if one of its channels differs by more
    double percent = 1;   ///< of the pixels that may be off
    double patch = 0.03;  ///< greatest mean difference of a patch of `patch_size` by `patch_size` pixels
};

/// Pixels along a side of a patch: about the width of an arrow. A change that a person would notice fills a patch;
/// edges that two rasterisers draw a little differently are thin lines in it.
constexpr int patch_size = 8;

/// The reason for the answer, in the order of the checks.
enum class Verdict {
    same,
    size,
    channels,
    not_finite,  ///< a value of either is NaN or infinite
    values,
};

/// One of the pixels that differ most.
struct PixelPair {
    int column = 0;
    int row = 0;
    float difference = 0;
    std::vector<float> a;
    std::vector<float> b;
};

/// How two pictures compare. Apart from `verdict` and `reason` only the results of checks that were reached are filled
/// in: pictures that differ in size have no numbers.
struct Comparison {
    Verdict verdict = Verdict::same;
    std::string reason;  ///< why they are not the same, for people; empty if they are
    double mean = 0;     ///< of the absolute differences of all values
    double max = 0;
    double rms = 0;
    double psnr = 0;               ///< dB for values 0..1; infinite if nothing differs
    std::int64_t off = 0;          ///< pixels that differ by more than the tolerance's level
    double percent = 0;            ///< the same, of all
    double patch = 0;              ///< mean difference of the patch that differs most
    std::vector<PixelPair> worst;  ///< at most ten that differ, the worst first
    Plane<float> pixels;           ///< the largest difference of each pixel's channels

    bool has_numbers() const { return !pixels.empty(); }
};

Comparison compare(const Samples& a, const Samples& b, const Tolerance& tolerance = {});

/// The differences of two pictures over the first of them in pale grey: from yellow for the smallest, through red, to
/// black for all of the range. Weak differences are amplified, so that all are visible.
/// \param comparison with numbers
Picture difference_picture(const Samples& a, const Comparison& comparison);

/// The same in letters for a terminal, at most `columns` wide, framed: the strongest difference of each cell, from
/// ` ` for at most `level`, by way of `.:-=+*#%`, to `@` for all of the range.
std::string difference_letters(const Plane<float>& pixels, double level, int columns = 60);

}  // namespace vvr::image
