#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"
#include "core/base/setting.h"

namespace vvr::space {

/// The two corners of each edge of a hexahedron. Bits 0, 1, 2 of a corner's index are set at the upper end of the
/// first, second, third axis.
inline constexpr std::array<std::array<int, 2>, 12> hexahedron_edges = {
    {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

/// The two faces that meet at each of these edges. Faces 0 to 5: low and high end of the first, second, third axis.
inline constexpr std::array<std::array<int, 2>, 12> hexahedron_edge_faces = {
    {{2, 4}, {3, 4}, {2, 5}, {3, 5}, {0, 4}, {1, 4}, {0, 5}, {1, 5}, {0, 2}, {1, 2}, {0, 3}, {1, 3}}};

/// User settings of a layout's shape, in P-space units.
struct LayoutOptions {
    double r_min = 0.45;  ///< inner radius of the horseshoe
    double r_max = 1;     ///< outer radius
    double height = 0;    ///< of a frame; 0 = pixels are square
};

/// Dimensions of a layout in P-space units.
struct LayoutShape {
    double r_min = 0;
    double r_max = 0;
    double y_s = 0;  ///< height of a frame
};

/// The shape for frames of size `field`. Square pixels mean y_s = Δr · H / W.
LayoutShape shape_for(Size field, const LayoutOptions& options = {});

/// The vectors ∂P/∂x_C, ∂P/∂y_C, ∂P/∂t_C at a point (§5.2). The paper's e_t has Δr where differentiation gives r.
struct Basis {
    glm::dvec3 x;
    glm::dvec3 y;
    glm::dvec3 t;

    /// Transforms a vector from C-space to P-space: v_P = Σ e_i v_i.
    glm::dvec3 transform(const glm::dvec3& v) const { return v.x * x + v.y * y + v.z * t; }
};

/// A float uniform of a layout's shader.
struct LayoutUniform {
    const char* name;
    double value;
};

/// The map between C-space, (x_C, y_C, t_C) in [0,1]³, and P-space. P-space is left-handed: x right, y up, z away from
/// the default viewer.
class Layout {
  public:
    explicit Layout(const LayoutShape& shape) : shape_(shape) {}
    virtual ~Layout() = default;
    Layout(const Layout&) = delete;
    Layout& operator=(const Layout&) = delete;

    const LayoutShape& shape() const { return shape_; }

    virtual glm::dvec3 p_from_c(const glm::dvec3& c) const = 0;
    virtual glm::dvec3 c_from_p(const glm::dvec3& p) const = 0;
    virtual Basis basis(const glm::dvec3& c) const = 0;

    /// The file in glsl/ that implements `c_from_p` for fragment shaders, in two steps. `local_from_p(p, t_reference)`
    /// is affine, so that vertices can interpolate it. `c_from_local(local, t_reference)` is exact in float for t_C
    /// within a cell of t_reference.
    virtual std::string_view shader() const = 0;

    /// Values of the uniforms that the shader declares.
    virtual std::vector<LayoutUniform> uniforms() const = 0;

    /// The longest interval of t_C that may be cut as a hexahedron with flat faces.
    virtual double straight_t() const = 0;

    /// Distance between the outer face of such a hexahedron and the curved volume, in x_C.
    virtual double sagitta_x(double t_length) const = 0;

    /// Indices of the sections between ascending t_C `borders` (n + 1 of them), farthest from `eye` first.
    ///
    /// Each section may be drawn completely before the next: no ray from the eye enters one section, then another, then
    /// the first again. This requires a plane that separates each pair of sections, as the box and the horseshoe (half
    /// a turn) have. With more than one turn, or stacked turns, no such order need exist.
    virtual std::vector<int> back_to_front(const glm::dvec3& eye, std::span<const double> borders) const = 0;

  private:
    LayoutShape shape_;
};

/// A layout by name. Its class has everything else: map, shader and uniforms.
struct LayoutRow {
    std::string name;
    std::string help;
    std::unique_ptr<Layout> (*make)(const LayoutShape&);
};

/// The first row is the default.
const std::vector<LayoutRow>& layouts();

std::unique_ptr<Layout> make_layout(const Choice<LayoutRow>& row, const LayoutShape& shape);

std::unique_ptr<Layout> make_horseshoe(const LayoutShape& shape);
std::unique_ptr<Layout> make_box(const LayoutShape& shape);

/// Indices of the sections between `borders`, from both ends towards the one that contains `t`: back to front if that
/// one faces the eye.
std::vector<int> sections_towards(double t, std::span<const double> borders);

const LayoutRow& row_of(Name<LayoutRow> name);

}  // namespace vvr::space
