#include "core/fields/illumination.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "core/fields/cv_view.h"

namespace vvr {
namespace {

// Levels between which a ratio says something: darker pixels are noise, brighter ones are cut off.
constexpr int darkest = 16;
constexpr int brightest = 245;

// A gain is the median of ratios; every few pixels are enough for it.
constexpr int sampling = 3;

constexpr double least_gain = 0.4;
constexpr double most_gain = 2.5;

/// Ratios of frame to reference, sorted into classes of a hundredth of an octave.
class Ratios {
  public:
    void add(int frame, int reference) {
        if (frame < darkest || frame > brightest || reference < darkest || reference > brightest) return;
        const double octaves = std::log2(static_cast<double>(frame) / reference);
        const int k = static_cast<int>(std::lround(octaves * classes_per_octave)) + middle;
        if (k < 0 || k >= std::ssize(counts_)) return;
        ++counts_[static_cast<std::size_t>(k)];
        ++total_;
    }

    int total() const { return total_; }

    double median() const {
        int below = 0;
        std::size_t k = 0;
        while (k + 1 < counts_.size() && 2 * (below + counts_[k]) <= total_) below += counts_[k++];
        // Within a class values are as good as evenly spread.
        const double part = counts_[k] == 0 ? 0.5 : (total_ / 2.0 - below) / counts_[k];
        return std::exp2((static_cast<double>(k) - 0.5 + part - middle) / classes_per_octave);
    }

  private:
    static constexpr int classes_per_octave = 100;
    static constexpr int middle = 150;

    std::array<int, 2 * middle + 1> counts_{};
    int total_ = 0;
};

double gain_of(const Planes& reference, const Planes& frame, const cv::Rect& part, double otherwise) {
    Ratios ratios;
    for (int j = part.y; j < part.y + part.height; j += sampling) {
        for (int i = part.x; i < part.x + part.width; i += sampling) {
            ratios.add(frame.grey.at(i, j), reference.grey.at(i, j));
        }
    }
    const int looked_at = ((part.width + sampling - 1) / sampling) * ((part.height + sampling - 1) / sampling);
    // With too few usable pixels there is nothing to learn.
    if (4 * ratios.total() < looked_at || ratios.total() == 0) return otherwise;
    return std::clamp(ratios.median(), least_gain, most_gain);
}

// A channel that was cut off at 255 may have been of any brightness: it is not made darker.
template <class T>
Plane<T> times(const Plane<T>& plane, double gain) {
    Plane<T> result(plane.size());
    std::array<std::uint8_t, 256> table{};
    for (int level = 0; level < 256; ++level) {
        const double lit = level > 250 ? std::max(gain, 1.0) * level : gain * level;
        table[static_cast<std::size_t>(level)] = static_cast<std::uint8_t>(std::min(std::lround(lit), 255L));
    }
    cv::Mat out = cv_view(result);
    cv::LUT(cv_view(plane), cv::Mat(1, 256, CV_8UC1, table.data()), out);
    return result;
}

Planes as_it_is(const Planes& reference, const Planes&) {
    return reference;
}

Planes relit_globally(const Planes& reference, const Planes& frame) {
    const double gain = light_gain(reference, frame);
    if (gain == 1) return reference;
    return {times(reference.grey, gain), reference.colour.empty() ? Plane<Bgr>{} : times(reference.colour, gain)};
}

// Blocks of a size that a person seldom fills; a gain must then agree with its neighbours', so that a coat is not
// taken for a shadow.
constexpr int block = 24;
constexpr double most_local_change = 1.5;

Plane<float> local_gains(const Planes& reference, const Planes& frame, double global) {
    const Size size = frame.grey.size();
    Plane<float> gains({(size.width + block - 1) / block, (size.height + block - 1) / block});
    for (int j = 0; j < gains.height(); ++j) {
        for (int i = 0; i < gains.width(); ++i) {
            // Half a block more on each side.
            const cv::Rect about(i * block - block / 2, j * block - block / 2, 2 * block, 2 * block);
            const double gain = gain_of(reference, frame, about & cv::Rect(0, 0, size.width, size.height), global);
            gains.at(i, j) =
                static_cast<float>(std::clamp(gain, global / most_local_change, global * most_local_change));
        }
    }
    Plane<float> smooth(gains.size());
    cv::Mat out = cv_view(smooth);
    cv::medianBlur(cv_view(gains), out, 5);
    return smooth;
}

template <class T>
Plane<T> times(const Plane<T>& plane, const cv::Mat& gains) {
    cv::Mat gains_of_channels = gains;
    if constexpr (std::is_same_v<T, Bgr>) cv::merge(std::vector<cv::Mat>(3, gains), gains_of_channels);
    Plane<T> result(plane.size());
    cv::Mat out = cv_view(result);
    cv::multiply(cv_view(plane), gains_of_channels, out, 1, out.type());
    return result;
}

Planes relit_locally(const Planes& reference, const Planes& frame) {
    const Size size = frame.grey.size();
    const Plane<float> blocks = local_gains(reference, frame, light_gain(reference, frame));
    // The block grid may reach beyond the picture: enlarged as it is, then cut.
    cv::Mat gains;
    cv::resize(cv_view(blocks), gains, {blocks.width() * block, blocks.height() * block}, 0, 0, cv::INTER_LINEAR);
    gains = gains(cv::Rect(0, 0, size.width, size.height));
    return {times(reference.grey, gains), reference.colour.empty() ? Plane<Bgr>{} : times(reference.colour, gains)};
}

constexpr std::array rows{
    IlluminationRow{"global", "one gain for the whole picture: exposure, clouds, lamps", true, relit_globally},
    IlluminationRow{"local", "a gain that varies over the picture: shadows, lamps at one side", true, relit_locally},
    IlluminationRow{"none", "every change of light counts", false, as_it_is},
};

}  // namespace

double light_gain(const Planes& reference, const Planes& frame) {
    const double gain = gain_of(reference, frame, {0, 0, frame.grey.width(), frame.grey.height()}, 1);
    // Less than a level in the brightest pixel.
    return std::abs(gain - 1) < 0.004 ? 1 : gain;
}

std::span<const IlluminationRow> illuminations() {
    return rows;
}

}  // namespace vvr
