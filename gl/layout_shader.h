#pragma once

#include <string_view>

#include "core/space/layout.h"
#include "gl/program.h"

namespace vvr {

/// The text of glsl/layout_NAME.glsl.
std::string_view layout_shader(const Layout& layout);

/// Gives the program in use the measures of the layout.
void set_layout(const Program& program, const Layout& layout);

}  // namespace vvr
