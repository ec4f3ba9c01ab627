#pragma once

namespace vvr {

/// Calls a function that loads a library, as dlopen does, and as a driver's own functions may. What the library throws
/// as it is loaded, where memory is short, leaves the loader locked, and the next thread that loads one would wait for
/// ever: so it ends the program instead (std::terminate).
template <class Work>
auto while_loading(const Work& work) noexcept {
    return work();
}

}  // namespace vvr
