#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/image/samples.h"

namespace vvr {

/// What two pictures may differ by and still count as the same. Values are 0..1, as the files hold them.
struct Tolerance {
    double level = 0.02;  ///< a pixel is off where one of its channels differs by more
    double percent = 1;   ///< so many of the pixels may be off
    double patch = 0.03;  ///< the mean difference of any patch of `patch_size` by `patch_size` pixels may be so large
};

/// Pixels along a side of a patch: about as wide as an arrow, so that a change a person would see fills one, while
/// edges that two rasterisers draw a little differently stay thin in it.
constexpr int patch_size = 8;

/// What the answer rests on, in the order in which it is looked at.
enum class Verdict {
    same,
    size,
    channels,
    not_finite,  ///< a value of either is no number, or infinite
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

/// How two pictures compare. Beyond `verdict` and `reason` only what was reached is filled in: of pictures that differ
/// in size, for one, there are no numbers.
struct Comparison {
    Verdict verdict = Verdict::same;
    std::string reason;  ///< why they are not the same, for people; empty where they are
    double mean = 0;     ///< of the absolute differences of all values
    double max = 0;
    double rms = 0;
    double psnr = 0;               ///< dB for values 0..1; infinite where nothing differs
    std::int64_t off = 0;          ///< pixels that differ by more than the tolerance's level
    double percent = 0;            ///< the same, of all
    double patch = 0;              ///< mean difference of the patch that differs most
    std::vector<PixelPair> worst;  ///< ten at most that differ, the worst first
    Plane<float> pixels;           ///< the largest difference of each pixel's channels

    bool has_numbers() const { return !pixels.empty(); }
};

Comparison compare(const Samples& a, const Samples& b, const Tolerance& tolerance = {});

}  // namespace vvr
