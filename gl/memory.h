#pragma once

#include <string_view>

namespace vvr::gl {

/// Does nothing but where the process may not have what OpenGL takes to begin with. Then a driver says anything of what
/// fails, and memory is to blame.
/// \param failure what it says
/// \throws Error limit
void throw_if_out_of_memory(std::string_view failure);

}  // namespace vvr::gl
