#pragma once

namespace vvr {

/// Mesa keeps compiled shaders in the user's folder of caches, and says so on stderr where it can't: for a user without
/// a home, as a service has. There it is told to do without. Changes the environment: call it before any thread.
void choose_shader_cache();

}  // namespace vvr
