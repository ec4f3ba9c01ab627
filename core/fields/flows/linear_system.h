#pragma once

#include <vector>

#include "core/fields/flows/derivatives.h"

namespace vvr::fields {

/// One grid of the linear equations to which Horn and Schunck's energy leads: at each point
///
///     J w + a (w - mean(w)) = f,   J = g gᵀ,  f = -g g_t,  a = α²
///
/// with the mean over the mask 1/6, 1/12 of [HS81]. Their fixed-point iteration (§4.1) is Jacobi's for it.
class LinearSystem {
  public:
    LinearSystem() = default;
    LinearSystem(Size size, float a) { reset(size, a); }

    /// Makes room for equations of so many points.
    void reset(Size size, float a);

    /// Takes the equations of derivatives.
    void load(const PlaneStack& derivatives);

    Size size() const { return work_.size(); }

    /// Jacobi steps.
    void relax(int steps);

    /// Takes w = 0.
    void clear();

    /// Takes a flow as w.
    void set(const Plane<float>& u, const Plane<float>& v);

    Flow flow() const { return {work_.plane(u()), work_.plane(v())}; }

    /// Makes `coarse` the same equations on a grid of half the size: J and f are means over 2×2 points, a is a quarter
    /// because the distance between points is twice as long.
    void restrict_to(LinearSystem& coarse) const;

    /// Gives the coarser system the residual of this one as its f, and w = 0.
    void restrict_residual(LinearSystem& coarse) const;

    /// Adds the coarser system's w, interpolated linearly.
    void add(const LinearSystem& coarse);

  private:
    enum WorkPlane { u_even, v_even, u_odd, v_odd, m11, m12, m22, c1, c2, work_planes };
    enum DataPlane { j11, j12, j22, f1, f2, data_planes };

    static Size half(Size size) { return {(size.width + 1) / 2, (size.height + 1) / 2}; }

    int u() const { return turn_ == 0 ? u_even : u_odd; }
    int v() const { return turn_ == 0 ? v_even : v_odd; }
    void invert();

    float a_ = 0;
    PlaneStack work_;  ///< flow before and after a step, taking turns, and the coefficients of a step
    PlaneStack data_;  ///< J and f
    int turn_ = 0;
};

/// Brings a flow nearer to the equations' solution by one V-cycle over ever coarser grids (Brandt 1977). Because
/// Jacobi's iteration with this mask damps every wave that the coarser grid can't hold by a factor of three or more a
/// step, a cycle takes the residual down by about ten.
class Multigrid {
  public:
    /// Does it again, be it for another size, in the same memory.
    void improve(const PlaneStack& derivatives, float a, const Flow& flow);

    LinearSystem& finest() { return grids_.front(); }

  private:
    void load(const PlaneStack& derivatives, float a);

    std::vector<LinearSystem> grids_;
    std::size_t used_ = 0;  ///< of them
};

}  // namespace vvr::fields
