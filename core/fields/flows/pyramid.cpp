#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"
#include "core/fields/flow.h"
#include "core/fields/flows/derivatives.h"
#include "core/fields/flows/linear_system.h"
#include "core/fields/thresholds.h"
#include "core/kernels/rows.h"

namespace vvr::fields {

namespace {

constexpr int border = 2;

/// Rows that may be read one vector beyond their end, with a border on each side.
class WideRows {
  public:
    WideRows(Size size)
        : stride_(static_cast<std::size_t>(size.width + 2 * border + 16)),
          values_(stride_ * static_cast<std::size_t>(size.height)),
          size_(size) {}

    float* row(int j) {
        return values_.data() + stride_ * static_cast<std::size_t>(std::clamp(j, 0, size_.height - 1)) + border;
    }

    void replicate_edges(int j) {
        std::fill_n(row(j) - border, border, row(j)[0]);
        std::fill_n(row(j) + size_.width, border, row(j)[size_.width - 1]);
    }

  private:
    std::size_t stride_;
    std::vector<float> values_;
    Size size_;
};

/// Derivatives of two frames after warping the second back by `flow`. The linear equations from them have the whole
/// flow as solution, not only its increment. Where the flow leads out of the picture, all derivatives are 0, because
/// nothing is known there.
///
/// \param here part `part` of the first frame; `flow` has its size
void warped_derivatives(const Plane<float>& here, const Plane<float>& next, const Flow& flow, const PixelBox& part,
                        PlaneStack& result) {
    const Size size = here.size();
    result.reset(size, derivative_planes);
    // The derivatives of both frames' mean lie midway between them: the error is least.
    WideRows mean(size), change(size), known(size), here_rows({size.width, 1}), u({size.width, 1}), v({size.width, 1});
    for (int j = 0; j < size.height; ++j) {
        std::ranges::copy(here.row(j), here_rows.row(0));
        std::ranges::copy(flow.u.row(j), u.row(0));
        std::ranges::copy(flow.v.row(j), v.row(0));
        kernels::warp_row({next, part.left, part.top + j, here_rows.row(0), u.row(0), v.row(0), mean.row(j),
                           change.row(j), known.row(j), size.width});
        mean.replicate_edges(j);
    }
    for (int j = 0; j < size.height; ++j) {
        const float* const row = mean.row(j);
        const std::array<const float*, 5> across{row - 2, row - 1, row, row + 1, row + 2};
        const std::array<const float*, 5> down{mean.row(j - 2), mean.row(j - 1), row, mean.row(j + 1), mean.row(j + 2)};
        kernels::weighted_sum(across, five_point, result.row(along_x, j), size.width);
        kernels::weighted_sum(down, five_point, result.row(along_y, j), size.width);
        std::ranges::copy(flow.u.row(j), u.row(0));
        std::ranges::copy(flow.v.row(j), v.row(0));
        kernels::whole_change(u.row(0), v.row(0), change.row(j), known.row(j), result.row(along_x, j),
                              result.row(along_y, j), result.row(along_t, j), size.width);
    }
}

Size half(Size size) {
    return {(size.width + 1) / 2, (size.height + 1) / 2};
}

/// Half the size. New points lie between old ones, hence the symmetric taps (1, 3, 3, 1)/8.
Plane<float> downsampled(const Plane<float>& plane) {
    const Size size = half(plane.size());
    auto rows = Plane<float>::for_overwrite({plane.width(), size.height});
    const auto at = [](std::span<const float> values, int i) {
        return values[static_cast<std::size_t>(std::clamp(i, 0, static_cast<int>(values.size()) - 1))];
    };
    for (int j = 0; j < size.height; ++j) {
        const std::array rows_in{plane.row(std::max(2 * j - 1, 0)), plane.row(2 * j),
                                 plane.row(std::min(2 * j + 1, plane.height() - 1)),
                                 plane.row(std::min(2 * j + 2, plane.height() - 1))};
        const std::span<float> out = rows.row(j);
        for (std::size_t i = 0; i < out.size(); ++i) {
            out[i] = (rows_in[0][i] + rows_in[3][i] + 3 * (rows_in[1][i] + rows_in[2][i])) / 8;
        }
    }
    auto result = Plane<float>::for_overwrite(size);
    for (int j = 0; j < size.height; ++j) {
        const std::span<const float> in = std::as_const(rows).row(j);
        for (int i = 0; i < size.width; ++i) {
            result.at(i, j) = (at(in, 2 * i - 1) + at(in, 2 * i + 2) + 3 * (at(in, 2 * i) + at(in, 2 * i + 1))) / 8;
        }
    }
    return result;
}

/// A flow scaled from half the size to `size`: interpolated linearly, and doubled.
Plane<float> upsampled(const Plane<float>& coarse, Size size) {
    auto fine = Plane<float>::for_overwrite(size);
    // One coarse row with its edge values replicated.
    std::vector<float> down(static_cast<std::size_t>(coarse.width()) + 2);
    for (int j = 0; j < size.height; ++j) {
        const std::span<const float> near = coarse.row(j / 2);
        const std::span<const float> far =
            coarse.row(std::clamp(j / 2 + (j % 2 == 0 ? -1 : 1), 0, coarse.height() - 1));
        for (std::size_t i = 0; i < near.size(); ++i) down[i + 1] = 1.5F * near[i] + 0.5F * far[i];
        down.front() = down[1];
        down.back() = down[near.size()];
        const std::span<float> out = fine.row(j);
        for (std::size_t i = 0; i < out.size(); i += 2) out[i] = 0.75F * down[i / 2 + 1] + 0.25F * down[i / 2];
        for (std::size_t i = 1; i < out.size(); i += 2) out[i] = 0.75F * down[i / 2 + 1] + 0.25F * down[i / 2 + 2];
    }
    return fine;
}

/// A 3×3 median filter. Between iterations it removes single outliers and keeps motion boundaries (Sun, Roth and Black,
/// CVPR 2010).
Plane<float> median_of_nine(const Plane<float>& plane) {
    auto result = Plane<float>::for_overwrite(plane.size());
    cv::medianBlur(cv_view(plane), cv_view(result), 3);
    return result;
}

class Pyramid final : public FlowMethod {
  public:
    explicit Pyramid(const SolverSettings& settings)
        : alpha2_(static_cast<float>(settings.alpha * settings.alpha)),
          warps_(settings.iterations),
          taps_(gaussian_taps(thresholds.flow.pyramid_smooth)) {}

    int reach() const override { return 1; }
    int margin() const override { return 16; }

    FlowFrame prepare(const Plane<std::uint8_t>& grey) const override {
        FlowFrame frame{grey, {smoothed(grey, taps_)}};
        while (std::min(frame.levels.back().width(), frame.levels.back().height()) >=
               2 * thresholds.flow.smallest_level) {
            frame.levels.push_back(downsampled(frame.levels.back()));
        }
        return frame;
    }

    // From this frame to the next; at the clip's end, from the previous frame to this one.
    Flow operator()(std::span<const FlowFrame* const> frames, const PixelBox& part) const override {
        const std::size_t first = frames[2] == frames[1] ? 0 : 1;
        const std::vector<Plane<float>>& here = frames[first]->levels;
        const std::vector<Plane<float>>& next = frames[first + 1]->levels;
        const std::vector<PixelBox> parts = parts_of(part, here);
        Flow flow;
        for (std::size_t k = here.size(); k-- > 0;) {
            const Size size = parts[k].size();
            flow = k + 1 == here.size() ? Flow{Plane<float>(size), Plane<float>(size)}
                                        : Flow{upsampled(flow.u, size), upsampled(flow.v, size)};
            improve(flow, cropped(here[k], parts[k]), next[k], parts[k]);
        }
        const PixelBox wanted = part.translated(-parts[0].left, -parts[0].top);
        return wanted.size() == parts[0].size() ? flow : Flow{cropped(flow.u, wanted), cropped(flow.v, wanted)};
    }

  private:
    // The part on every pyramid level; on the finest one slightly larger than requested, so that all levels cover the
    // same points.
    static std::vector<PixelBox> parts_of(const PixelBox& part, const std::vector<Plane<float>>& levels) {
        const int cell = 1 << (levels.size() - 1);
        const int left = part.left / cell * cell;
        const int top = part.top / cell * cell;
        std::vector<PixelBox> parts;
        Size size{part.right - left, part.bottom - top};
        for (std::size_t k = 0; k < levels.size(); ++k) {
            parts.push_back({left >> k, top >> k, (left >> k) + size.width, (top >> k) + size.height});
            size = half(size);
        }
        return parts;
    }

    void improve(Flow& flow, const Plane<float>& here, const Plane<float>& next, const PixelBox& part) const {
        Workspace& work = workspaces_.local();
        for (int i = 0; i < warps_; ++i) {
            warped_derivatives(here, next, flow, part, work.derivatives);
            work.grids.improve(work.derivatives, alpha2_, flow);
            const Flow solved = work.grids.finest().flow();
            step_toward(flow.u, median_of_nine(solved.u));
            step_toward(flow.v, median_of_nine(solved.v));
        }
    }

    static void step_toward(Plane<float>& flow, const Plane<float>& solved) {
        std::ranges::transform(flow.pixels(), solved.pixels(), flow.pixels().begin(), [](float from, float to) {
            return from + std::clamp(to - from, -thresholds.flow.longest_step, thresholds.flow.longest_step);
        });
    }

    /// A thread's buffers, which it reuses for each frame.
    struct Workspace {
        PlaneStack derivatives;
        Multigrid grids;
    };

    float alpha2_;
    int warps_;
    std::vector<float> taps_;
    mutable oneapi::tbb::enumerable_thread_specific<Workspace> workspaces_;
};

}  // namespace

std::unique_ptr<FlowMethod> make_pyramid(const SolverSettings& settings) {
    return std::make_unique<Pyramid>(settings);
}

}  // namespace vvr::fields
