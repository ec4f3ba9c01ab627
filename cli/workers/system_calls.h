#pragma once

#include <vector>

#include <linux/filter.h>

namespace vvr::workers {

/// Why this kernel has no filters of system calls (seccomp), as in errno; 0 = it has them.
int call_filter_error();

/// The system calls that a worker may make, some of them with some arguments alone. Others fail as on a kernel that is
/// too old for them; a few that nothing has a reason for end the process (SIGSYS). It still starts threads, takes
/// memory, also to compile shaders into, and uses the files that it is allowed.
class CallFilter {
  public:
    /// \param gpu with the ioctls of a graphics card's devices
    /// \throws Error backend when it can't be made
    explicit CallFilter(bool gpu);

    /// Holds for the calling thread and for what it starts from now on. Allocates nothing, so it may stand between fork
    /// and exec. The thread must have given up new privileges (PR_SET_NO_NEW_PRIVS). What a worker needs to begin is
    /// still allowed: see block_startup_calls.
    /// \returns whether it does
    bool enforce() const;

  private:
    std::vector<sock_filter> program_;
};

/// Gives up, for all threads of this process, what a CallFilter left it to begin with: to become a program, and to
/// filter calls; and to signal any process but itself.
/// \returns whether it did
bool block_startup_calls();

}  // namespace vvr::workers
