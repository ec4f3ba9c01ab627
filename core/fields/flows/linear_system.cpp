#include "core/fields/flows/linear_system.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/fields/thresholds.h"
#include "core/kernels/rows.h"

namespace vvr::fields {
namespace {

// Rows per iteration and turn, and iterations that run through the picture together, each a row behind the previous
// one. Their working set, some 24 rows of nine planes, fits the second-level cache. Both numbers were measured; the
// optimum is flat.
constexpr int rows_at_a_time = 2;
constexpr int steps_together = 20;

}  // namespace

void LinearSystem::reset(Size size, float a) {
    a_ = a;
    work_.reset(size, work_planes);
    data_.reset(size, data_planes);
    turn_ = 0;
}

void LinearSystem::load(const PlaneStack& derivatives) {
    for (int j = 0; j < size().height; ++j) {
        const float* const gx = derivatives.row(along_x, j);
        const float* const gy = derivatives.row(along_y, j);
        const float* const gt = derivatives.row(along_t, j);
        float* const m_and_c[] = {work_.row(m11, j), work_.row(m12, j), work_.row(m22, j), work_.row(c1, j),
                                  work_.row(c2, j)};
        float* const j_and_f[] = {data_.row(j11, j), data_.row(j12, j), data_.row(j22, j), data_.row(f1, j),
                                  data_.row(f2, j)};
        kernels::invert_gradients(gx, gy, gt, a_, m_and_c, size().width);
        kernels::products(gx, gy, gt, j_and_f, size().width);
    }
}

void LinearSystem::invert() {
    for (int j = 0; j < size().height; ++j) {
        const float* const j_and_f[] = {data_.row(j11, j), data_.row(j12, j), data_.row(j22, j), data_.row(f1, j),
                                        data_.row(f2, j)};
        float* const m_and_c[] = {work_.row(m11, j), work_.row(m12, j), work_.row(m22, j), work_.row(c1, j),
                                  work_.row(c2, j)};
        kernels::invert_tensors(j_and_f, a_, m_and_c, size().width);
    }
}

void LinearSystem::clear() {
    work_.clear(u());
    work_.clear(v());
}

void LinearSystem::set(const Plane<float>& new_u, const Plane<float>& new_v) {
    for (int j = 0; j < size().height; ++j) {
        std::ranges::copy(new_u.row(j), work_.row(u(), j));
        std::ranges::copy(new_v.row(j), work_.row(v(), j));
    }
    work_.replicate_border(u());
    work_.replicate_border(v());
}

// Iteration k works a row above iteration k - 1. It overwrites the flow of iteration k - 2, whose last reader was
// iteration k - 1 at the row below, just before.
void LinearSystem::relax(int steps) {
    const int height = size().height;
    while (steps > 0) {
        const int together = std::min(steps, steps_together);
        for (int j = 0; j < height + together - 1; j += rows_at_a_time) {
            for (int k = 0; k < together; ++k) {
                const int first = std::max(j - k, 0);
                const int last = std::min(j - k + rows_at_a_time, height);
                if (first >= last) continue;
                const bool even = (turn_ + k) % 2 == 0;
                const int next_u = even ? u_odd : u_even;
                const int next_v = even ? v_odd : v_even;
                kernels::relax_rows({.u = work_.row(even ? u_even : u_odd, first),
                                     .v = work_.row(even ? v_even : v_odd, first),
                                     .m11 = work_.row(m11, first),
                                     .m12 = work_.row(m12, first),
                                     .m22 = work_.row(m22, first),
                                     .c1 = work_.row(c1, first),
                                     .c2 = work_.row(c2, first),
                                     .next_u = work_.row(next_u, first),
                                     .next_v = work_.row(next_v, first),
                                     .pitch = work_.pitch()},
                                    size().width, last - first);
                work_.replicate_border(next_u, first, last);
                work_.replicate_border(next_v, first, last);
            }
        }
        turn_ = (turn_ + together) % 2;
        steps -= together;
    }
}

void LinearSystem::restrict_to(LinearSystem& coarse) const {
    coarse.reset(half(size()), a_ / 4);
    const int width = size().width;
    for (int j = 0; j < coarse.size().height; ++j) {
        const int lower = std::min(2 * j + 1, size().height - 1);
        for (const int plane : {j11, j12, j22, f1, f2}) {
            float* const out = coarse.data_.row(plane, j);
            kernels::mean_of_pairs(data_.row(plane, 2 * j), data_.row(plane, lower), out, coarse.size().width);
            if (width % 2 == 1) {
                out[width / 2] = (data_.row(plane, 2 * j)[width - 1] + data_.row(plane, lower)[width - 1]) / 2;
            }
        }
    }
    coarse.invert();
}

void LinearSystem::restrict_residual(LinearSystem& coarse) const {
    const auto width = static_cast<std::size_t>(size().width);
    const int coarse_width = coarse.size().width;
    const std::size_t room = static_cast<std::size_t>(coarse_width + 63) / 32 * 64;
    const auto r1 = aligned_floats(room);
    const auto r2 = aligned_floats(room);
    const std::array upper{aligned_floats(room), aligned_floats(room)};
    for (int j = 0; j < size().height; ++j) {
        kernels::residual_row(
            {.u_above = work_.row(u(), j - 1),
             .u = work_.row(u(), j),
             .u_below = work_.row(u(), j + 1),
             .v_above = work_.row(v(), j - 1),
             .v = work_.row(v(), j),
             .v_below = work_.row(v(), j + 1),
             .j_and_f = {data_.row(j11, j), data_.row(j12, j), data_.row(j22, j), data_.row(f1, j), data_.row(f2, j)}},
            a_, r1.get(), r2.get(), size().width);
        r1[width] = r1[width - 1];
        r2[width] = r2[width - 1];
        if (j % 2 == 0) {
            std::copy_n(r1.get(), width + 1, upper[0].get());
            std::copy_n(r2.get(), width + 1, upper[1].get());
            if (j + 1 < size().height) continue;
        }
        kernels::mean_of_pairs(upper[0].get(), r1.get(), coarse.data_.row(f1, j / 2), coarse_width);
        kernels::mean_of_pairs(upper[1].get(), r2.get(), coarse.data_.row(f2, j / 2), coarse_width);
    }
    coarse.invert();
    coarse.clear();
}

void LinearSystem::add(const LinearSystem& coarse) {
    for (int j = 0; j < size().height; ++j) {
        const int near = j / 2;
        const int far = j % 2 == 0 ? near - 1 : near + 1;
        kernels::add_interpolated(coarse.work_.row(coarse.u(), near), coarse.work_.row(coarse.u(), far),
                                  work_.row(u(), j), coarse.size().width);
        kernels::add_interpolated(coarse.work_.row(coarse.v(), near), coarse.work_.row(coarse.v(), far),
                                  work_.row(v(), j), coarse.size().width);
    }
    work_.replicate_border(u());
    work_.replicate_border(v());
}

void Multigrid::load(const PlaneStack& derivatives, float a) {
    const auto grid = [this](std::size_t k) -> LinearSystem& {
        if (k == grids_.size()) grids_.emplace_back();
        return grids_[k];
    };
    grid(0).reset(derivatives.size(), a);
    grids_.front().load(derivatives);
    used_ = 1;
    while (std::max(grids_[used_ - 1].size().width, grids_[used_ - 1].size().height) > thresholds.flow.coarsest) {
        LinearSystem& coarse = grid(used_);
        grids_[used_ - 1].restrict_to(coarse);
        ++used_;
    }
}

void Multigrid::improve(const PlaneStack& derivatives, float a, const Flow& flow) {
    load(derivatives, a);
    grids_.front().set(flow.u, flow.v);
    const std::size_t last = used_ - 1;
    for (std::size_t k = 0; k < last; ++k) {
        grids_[k].relax(2);
        grids_[k].restrict_residual(grids_[k + 1]);
    }
    grids_[last].relax(2 * thresholds.flow.coarsest);
    for (std::size_t k = last; k-- > 0;) {
        grids_[k].add(grids_[k + 1]);
        grids_[k].relax(1);
    }
}

}  // namespace vvr::fields
