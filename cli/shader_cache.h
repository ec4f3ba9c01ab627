#pragma once

namespace vvr::cli {

/// Chooses where Mesa caches compiled shaders. If the user's cache folder isn't writable (services have no home),
/// disables the cache: Mesa would print a warning. Otherwise sets MESA_SHADER_CACHE_DIR, which workers inherit: Mesa
/// would ask libc for the home folder, and libc can crash there when memory is short. Modifies the environment, so call
/// it before starting threads.
void choose_shader_cache();

}  // namespace vvr::cli
