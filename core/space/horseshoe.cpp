#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/space/layout.h"

namespace vvr::space {

namespace {

using std::numbers::pi;

/// Eq. (1): P = (-r cos πt, y_s y, r sin πt) with r = r_min + Δr x.
class Horseshoe final : public Layout {
  public:
    explicit Horseshoe(const LayoutShape& shape) : Layout(shape) {}

    glm::dvec3 p_from_c(const glm::dvec3& c) const override {
        const double r = radius(c.x);
        return {-r * std::cos(pi * c.z), shape().y_s * c.y, r * std::sin(pi * c.z)};
    }

    glm::dvec3 c_from_p(const glm::dvec3& p) const override {
        const double r = std::hypot(p.x, p.z);
        double t = std::atan2(p.z, -p.x) / pi;
        // Move the branch cut of atan2 to the middle of the open side.
        if (t < -0.5) t += 2;
        return {(r - shape().r_min) / depth(), p.y / shape().y_s, t};
    }

    Basis basis(const glm::dvec3& c) const override {
        const double dr = depth();
        const double r = radius(c.x);
        const double cosine = std::cos(pi * c.z);
        const double sine = std::sin(pi * c.z);
        return {{-dr * cosine, 0, dr * sine}, {0, shape().y_s, 0}, {pi * r * sine, 0, pi * r * cosine}};
    }

    std::string_view shader() const override { return "layout_horseshoe.glsl"; }

    std::vector<LayoutUniform> uniforms() const override {
        return {{"layout_r_min", shape().r_min}, {"layout_depth", depth()}, {"layout_height", shape().y_s}};
    }

    double straight_t() const override { return 0.064 / pi; }

    double sagitta_x(double t_length) const override {
        return shape().r_max * (1 - std::cos(pi * t_length / 2)) / depth();
    }

    std::vector<int> back_to_front(const glm::dvec3& eye, std::span<const double> borders) const override {
        const double angle = std::atan2(eye.z, -eye.x);
        const bool before_open_side = angle < 0;
        // An eye before the open side: use the opposite direction and reverse the order.
        std::vector<int> order = sections_towards((before_open_side ? angle + pi : angle) / pi, borders);
        if (before_open_side) std::ranges::reverse(order);
        return order;
    }

  private:
    double depth() const { return shape().r_max - shape().r_min; }
    double radius(double x) const { return shape().r_min + depth() * x; }
};

}  // namespace

std::unique_ptr<Layout> make_horseshoe(const LayoutShape& shape) {
    return std::make_unique<Horseshoe>(shape);
}

}  // namespace vvr::space
