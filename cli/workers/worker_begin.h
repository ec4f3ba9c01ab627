#pragma once

#include <string>
#include <string_view>

namespace vvr::workers {

/// The environment variable by which a worker is told that it is one.
inline constexpr std::string_view worker_variable = "VVR_WORKER";

/// What that variable says.
/// \param ready a descriptor that the worker inherits, to say that it has begun
/// \param confined whether a CallFilter is around it
std::string worker_value(int ready, bool confined);

/// In a worker: gives up what it needed to begin, and tells its parent that it has begun. So whatever comes later, a
/// worker that never began is known from one that a clip has ended. Elsewhere: nothing.
void begin_worker();

}  // namespace vvr::workers
