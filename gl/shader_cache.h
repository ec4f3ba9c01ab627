#pragma once

namespace vvr::gl {

/// Mesa keeps compiled shaders in the user's folder of caches, and says so on stderr where it can't: for a user without
/// a home, as a service has. There it is told to do without. Elsewhere MESA_SHADER_CACHE_DIR is the folder from then
/// on, for Mesa and for the workers that inherit it: Mesa would ask libc for the user's home, and libc crashes there
/// where memory is short. Changes the environment: call it before any thread.
void choose_shader_cache();

}  // namespace vvr::gl
