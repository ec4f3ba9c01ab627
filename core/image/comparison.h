#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/image/picture.h"
#include "core/image/picture_file.h"

namespace vvr::image {

/// The tolerance within which two pictures count as the same. Pixel values are 0..1.
struct Tolerance {
    double level = 0.02;  ///< a pixel is off if one of its channels differs by more
    double percent = 1;   ///< of the pixels that may be off
    double patch = 0.03;  ///< maximum mean difference within a patch
};

/// Side of a square patch, pixels: about the width of an arrow. A visible change fills a patch, while differences
/// between rasterisers are thin lines.
constexpr int patch_size = 8;

/// The result of a comparison: `same`, or the first check that failed, in this order.
enum class Verdict {
    same,
    size,
    channels,
    not_finite,  ///< a picture has NaN or infinite values
    values,
};

/// A pixel that differs in two pictures.
struct PixelPair {
    int column = 0;
    int row = 0;
    float difference = 0;
    std::vector<float> a;
    std::vector<float> b;
};

/// The result of a comparison. If a check before `values` fails, only `verdict` and `reason` are set.
struct Comparison {
    Verdict verdict = Verdict::same;
    std::string reason;  ///< for the user; empty if the pictures are the same
    double mean = 0;     ///< mean absolute difference of all values
    double max = 0;
    double rms = 0;
    double psnr = 0;               ///< dB; infinite if nothing differs
    std::int64_t off = 0;          ///< pixels that differ by more than the tolerance's level
    double percent = 0;            ///< `off` as a percentage of all pixels
    double patch = 0;              ///< largest mean difference of a patch
    std::vector<PixelPair> worst;  ///< at most ten pixels, largest difference first
    Plane<float> pixels;           ///< maximum difference over the channels, per pixel

    bool has_numbers() const { return !pixels.empty(); }
};

Comparison compare(const Samples& a, const Samples& b, const Tolerance& tolerance = {});

/// Draws the differences of two pictures over a pale grey version of the first one: from yellow for the smallest,
/// through red, to black for the full range. Small differences are amplified.
/// \pre comparison.has_numbers()
Picture difference_picture(const Samples& a, const Comparison& comparison);

/// Draws the differences as framed text for a terminal. Each character is the largest difference of its cell: ` ` up to
/// `level`, then `.:-=+*#%`, and `@` for the full range.
/// \param columns maximum width, characters
std::string difference_letters(const Plane<float>& pixels, double level, int columns = 60);

}  // namespace vvr::image
