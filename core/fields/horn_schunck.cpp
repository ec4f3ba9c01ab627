#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "core/fields/cv_view.h"
#include "core/fields/flow.h"

namespace vvr {
namespace {

/// The three derivatives of the grey levels at one frame, in levels a pixel and levels a frame.
struct Derivatives {
    Plane<float> x, y, t;
};

std::vector<float> gaussian(double sigma) {
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    std::vector<float> taps;
    double sum = 0;
    for (int i = -radius; i <= radius; ++i) sum += std::exp(-i * i / (2 * sigma * sigma));
    for (int i = -radius; i <= radius; ++i) {
        taps.push_back(static_cast<float>(std::exp(-i * i / (2 * sigma * sigma)) / sum));
    }
    return taps;
}

constexpr float five_point[5] = {1.F / 12, -8.F / 12, 0, 8.F / 12, -1.F / 12};

// What the five-point derivative makes of a signal that was smoothed with `taps`, as one set of taps.
std::vector<float> differentiated(const std::vector<float>& taps) {
    std::vector<float> result(taps.size() + 4, 0.F);
    for (std::size_t i = 0; i < taps.size(); ++i) {
        for (std::size_t k = 0; k < 5; ++k) result[i + k] += taps[i] * five_point[k];
    }
    return result;
}

Plane<float> weighted_sum(std::span<const FlowFrame* const> frames, std::span<const float> weights) {
    Plane<float> result(frames.front()->smooth.size());
    float* const out = result.pixels().data();
    const std::size_t count = result.pixels().size();
    for (std::size_t k = 0; k < weights.size(); ++k) {
        const float weight = weights[k];
        const float* const in = frames[k]->smooth.pixels().data();
        for (std::size_t i = 0; i < count; ++i) out[i] += weight * in[i];
    }
    return result;
}

Plane<float> derivative(const Plane<float>& plane, bool along_rows) {
    Plane<float> result(plane.size());
    cv::Mat out = cv_view(result);
    const cv::Mat taps(1, 5, CV_32FC1, const_cast<float*>(five_point));
    const cv::Mat one = cv::Mat::ones(1, 1, CV_32FC1);
    cv::sepFilter2D(cv_view(plane), out, CV_32F, along_rows ? taps : one, along_rows ? one : taps, {-1, -1}, 0,
                    cv::BORDER_REPLICATE);
    return result;
}

/// A plane with a border one pixel wide that repeats its edge, so that the averaging mask needs no special case.
class Bordered {
  public:
    explicit Bordered(Size size)
        : width_(size.width),
          height_(size.height),
          values_(static_cast<std::size_t>((size.width + 2) * (size.height + 2))) {}

    float* row(int j) { return values_.data() + (j + 1) * (width_ + 2) + 1; }
    const float* row(int j) const { return values_.data() + (j + 1) * (width_ + 2) + 1; }

    void repeat_edges() {
        for (int j = 0; j < height_; ++j) {
            row(j)[-1] = row(j)[0];
            row(j)[width_] = row(j)[width_ - 1];
        }
        std::copy_n(row(0) - 1, width_ + 2, row(-1) - 1);
        std::copy_n(row(height_ - 1) - 1, width_ + 2, row(height_) - 1);
    }

    Plane<float> plane() const {
        Plane<float> result({width_, height_});
        for (int j = 0; j < height_; ++j) std::copy_n(row(j), width_, result.row(j).begin());
        return result;
    }

  private:
    int width_;
    int height_;
    std::vector<float> values_;
};

// The mask of [HS81]: a sixth of the four neighbours, a twelfth of the diagonal ones.
float average(const float* above, const float* here, const float* below, int i) {
    return (above[i] + below[i] + here[i - 1] + here[i + 1]) * (1.F / 6) +
           (above[i - 1] + above[i + 1] + below[i - 1] + below[i + 1]) * (1.F / 12);
}

Flow jacobi(const Derivatives& d, double alpha, int steps) {
    const Size size = d.x.size();
    const auto alpha2 = static_cast<float>(alpha * alpha);
    Bordered u(size), v(size), next_u(size), next_v(size);
    Plane<float> scale(size);
    std::ranges::transform(d.x.pixels(), d.y.pixels(), scale.pixels().begin(),
                           [&](float x, float y) { return 1 / (alpha2 + x * x + y * y); });
    for (int step = 0; step < steps; ++step) {
        for (int j = 0; j < size.height; ++j) {
            const float* const dx = d.x.row(j).data();
            const float* const dy = d.y.row(j).data();
            const float* const dt = d.t.row(j).data();
            const float* const s = scale.row(j).data();
            const float *const u0 = u.row(j - 1), *const u1 = u.row(j), *const u2 = u.row(j + 1);
            const float *const v0 = v.row(j - 1), *const v1 = v.row(j), *const v2 = v.row(j + 1);
            float* __restrict const out_u = next_u.row(j);
            float* __restrict const out_v = next_v.row(j);
            for (int i = 0; i < size.width; ++i) {
                const float mean_u = average(u0, u1, u2, i);
                const float mean_v = average(v0, v1, v2, i);
                const float error = (dx[i] * mean_u + dy[i] * mean_v + dt[i]) * s[i];
                out_u[i] = mean_u - dx[i] * error;
                out_v[i] = mean_v - dy[i] * error;
            }
        }
        next_u.repeat_edges();
        next_v.repeat_edges();
        std::swap(u, next_u);
        std::swap(v, next_v);
    }
    return {u.plane(), v.plane()};
}

class HornSchunck final : public FlowMethod {
  public:
    explicit HornSchunck(const FlowOptions& options)
        : options_(options),
          smoothing_(options.pre_smooth > 0 ? gaussian(options.pre_smooth) : std::vector<float>{1}),
          change_(differentiated(smoothing_)) {}

    int reach() const override { return static_cast<int>(change_.size() / 2); }

    Plane<float> prepare(const Plane<std::uint8_t>& grey) const override {
        Plane<float> result(grey.size());
        cv::Mat out = cv_view(result);
        cv::sepFilter2D(cv_view(grey), out, CV_32F, smoothing_, smoothing_, {-1, -1}, 0, cv::BORDER_REPLICATE);
        return result;
    }

    // Smoothing in t and differentiating are both weighted sums over the frames, so they are taken in one.
    Flow operator()(std::span<const FlowFrame* const> frames) const override {
        const Plane<float> smooth = weighted_sum(frames.subspan(2, smoothing_.size()), smoothing_);
        return jacobi({derivative(smooth, true), derivative(smooth, false), weighted_sum(frames, change_)},
                      options_.alpha, options_.iterations);
    }

  private:
    FlowOptions options_;
    std::vector<float> smoothing_;
    std::vector<float> change_;
};

}  // namespace

std::unique_ptr<FlowMethod> make_horn_schunck(const FlowOptions& options) {
    return std::make_unique<HornSchunck>(options);
}

}  // namespace vvr
