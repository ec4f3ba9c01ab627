#include "core/fields/flows/warp.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "core/kernels/warp_rows.h"
#include "core/kernels/weighted_sum.h"

namespace vvr::fields {
namespace {

constexpr int border = 2;

/// Rows that may be read a vector beyond their end, with a border on each side.
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

}  // namespace

void warped_derivatives(const Plane<float>& here, const Plane<float>& next, const Flow& flow, const Rect& part,
                        PlaneStack& result) {
    const Size size = here.size();
    result.reset(size, derivative_planes);
    // The mean of both frames has the derivatives midway between them, which errs least.
    WideRows mean(size), change(size), known(size), here_rows({size.width, 1}), u({size.width, 1}), v({size.width, 1});
    for (int j = 0; j < size.height; ++j) {
        std::ranges::copy(here.row(j), here_rows.row(0));
        std::ranges::copy(flow.u.row(j), u.row(0));
        std::ranges::copy(flow.v.row(j), v.row(0));
        kernels::warp_row({next, part.x, part.y + j, here_rows.row(0), u.row(0), v.row(0), mean.row(j), change.row(j),
                           known.row(j), size.width});
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

}  // namespace vvr::fields
