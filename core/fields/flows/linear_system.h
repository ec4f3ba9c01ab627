#pragma once

#include <vector>

#include "core/fields/flows/derivatives.h"

namespace vvr::fields {

/// One grid level of the linear system of Horn and Schunck's energy. At each point
///
///     J w + a (w - mean(w)) = f,   J = g gᵀ,  f = -g g_t,  a = α²
///
/// where mean is the mask of 1/6 and 1/12 in [HS81]. Their fixed-point iteration (§4.1) is the Jacobi iteration of this
/// system.
class LinearSystem {
  public:
    LinearSystem() = default;
    LinearSystem(Size size, float a) { reset(size, a); }

    /// Allocates the system for a grid of this size.
    void reset(Size size, float a);

    /// Sets J and f from derivatives.
    void load(const PlaneStack& derivatives);

    Size size() const { return work_.size(); }

    /// Does Jacobi iterations.
    void relax(int steps);

    /// Sets w = 0.
    void clear();

    /// Sets w to a flow.
    void set(const Plane<float>& u, const Plane<float>& v);

    Flow flow() const { return {work_.plane(u()), work_.plane(v())}; }

    /// Restricts the system to a grid of half the size: J and f are means over 2×2 points; a is a quarter, because the
    /// grid spacing doubles.
    void restrict_to(LinearSystem& coarse) const;

    /// Sets f of the coarser system to this system's residual, and its w to 0.
    void restrict_residual(LinearSystem& coarse) const;

    /// Adds the w of the coarser system, interpolated linearly.
    void add(const LinearSystem& coarse);

  private:
    enum WorkPlane { u_even, v_even, u_odd, v_odd, m11, m12, m22, c1, c2, work_planes };
    enum DataPlane { j11, j12, j22, f1, f2, data_planes };

    static Size half(Size size) { return {(size.width + 1) / 2, (size.height + 1) / 2}; }

    int u() const { return turn_ == 0 ? u_even : u_odd; }
    int v() const { return turn_ == 0 ? v_even : v_odd; }
    void invert();

    float a_ = 0;
    PlaneStack work_;  ///< flow before and after an iteration, alternating, and its coefficients
    PlaneStack data_;  ///< J and f
    int turn_ = 0;
};

/// A multigrid solver: one V-cycle over ever coarser grids (Brandt 1977). Jacobi iteration with this mask damps all
/// waves that the coarser grid can't represent by a factor of three or more per iteration; so a cycle reduces the
/// residual about tenfold.
class Multigrid {
  public:
    /// Prepares for a system of any size, reusing memory.
    void improve(const PlaneStack& derivatives, float a, const Flow& flow);

    LinearSystem& finest() { return grids_.front(); }

  private:
    void load(const PlaneStack& derivatives, float a);

    std::vector<LinearSystem> grids_;
    std::size_t used_ = 0;  ///< number of levels in use
};

}  // namespace vvr::fields
