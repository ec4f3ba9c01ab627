#include <numbers>

#include "core/space/layout.h"

namespace vvr::space {

namespace {

/// The horseshoe straightened along the arc of its middle radius. Handedness is kept, so frames read unmirrored from
/// the same side in both.
class Box final : public Layout {
  public:
    explicit Box(const LayoutShape& shape)
        : Layout(shape), length_(std::numbers::pi * (shape.r_min + shape.r_max) / 2) {}

    glm::dvec3 p_from_c(const glm::dvec3& c) const override {
        return {length_ * (c.z - 0.5), shape().y_s * c.y, depth() * c.x};
    }

    glm::dvec3 c_from_p(const glm::dvec3& p) const override {
        return {p.z / depth(), p.y / shape().y_s, p.x / length_ + 0.5};
    }

    Basis basis(const glm::dvec3&) const override { return {{0, 0, depth()}, {0, shape().y_s, 0}, {length_, 0, 0}}; }

    std::string_view shader() const override { return "layout_box.glsl"; }

    std::vector<LayoutUniform> uniforms() const override {
        return {{"layout_depth", depth()}, {"layout_height", shape().y_s}, {"layout_length", length_}};
    }

    double straight_t() const override { return 1; }
    double sagitta_x(double) const override { return 0; }

    std::vector<int> back_to_front(const glm::dvec3& eye, std::span<const double> borders) const override {
        return sections_towards(c_from_p(eye).z, borders);
    }

  private:
    double depth() const { return shape().r_max - shape().r_min; }

    double length_;
};

}  // namespace

std::unique_ptr<Layout> make_box(const LayoutShape& shape) {
    return std::make_unique<Box>(shape);
}

}  // namespace vvr::space
