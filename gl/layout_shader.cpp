#include "gl/layout_shader.h"

#include <array>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "shaders.h"

namespace vvr {

std::string_view layout_shader(const Layout& layout) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 2> table = {{
        {"horseshoe", shaders::layout_horseshoe_glsl},
        {"box", shaders::layout_box_glsl},
    }};
    for (const auto& [name, text] : table) {
        if (name == layout.name()) return text;
    }
    throw Error(ErrorKind::backend, fmt::format("there is no shader for layout '{}'", layout.name()));
}

void set_layout(const Program& program, const Layout& layout) {
    const LayoutShape& shape = layout.shape();
    const double length = std::numbers::pi * (shape.r_min + shape.r_max) / 2;
    program.set("layout_shape", glm::vec4(shape.r_min, shape.r_max - shape.r_min, shape.y_s, length));
}

}  // namespace vvr
