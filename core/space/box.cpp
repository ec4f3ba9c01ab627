#include <algorithm>
#include <numbers>

#include "core/space/layout.h"

namespace vvr {

namespace {

/// The horseshoe straightened along the arc of its middle radius, with the same handedness: a frame that reads
/// unmirrored from the volume's beginning does so in both.
class Box final : public Layout {
  public:
    explicit Box(const LayoutShape& shape)
        : Layout(shape), length_(std::numbers::pi * (shape.r_min + shape.r_max) / 2) {}

    std::string_view name() const override { return "box"; }

    glm::dvec3 p_from_c(const glm::dvec3& c) const override {
        return {length_ * (c.z - 0.5), shape().y_s * c.y, depth() * c.x};
    }

    glm::dvec3 c_from_p(const glm::dvec3& p) const override {
        return {p.z / depth(), p.y / shape().y_s, p.x / length_ + 0.5};
    }

    Basis basis(const glm::dvec3&) const override { return {{0, 0, depth()}, {0, shape().y_s, 0}, {length_, 0, 0}}; }

    double straight_t() const override { return 1; }
    double sagitta_x(double) const override { return 0; }

    std::vector<int> back_to_front(const glm::dvec3& eye, std::span<const double> borders) const override {
        const int n = static_cast<int>(borders.size()) - 1;
        const double t = c_from_p(eye).z;
        int split = 0;
        while (split < n - 1 && borders[static_cast<std::size_t>(split) + 1] <= t) ++split;
        std::vector<int> order;
        for (int i = 0; i < split; ++i) order.push_back(i);
        for (int i = n - 1; i >= split; --i) order.push_back(i);
        return order;
    }

  private:
    double depth() const { return shape().r_max - shape().r_min; }

    double length_;
};

}  // namespace

std::unique_ptr<Layout> make_box(const LayoutShape& shape) {
    return std::make_unique<Box>(shape);
}

}  // namespace vvr
