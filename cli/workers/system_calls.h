#pragma once

#include <vector>

#include <linux/filter.h>

namespace vvr::workers {

/// Why this kernel has no seccomp filters, as in errno; 0 = it has them.
int call_filter_error();

/// A seccomp filter with the system calls that a worker may make, some of them with certain arguments only. Others fail
/// with ENOSYS, as on an older kernel. A few that no library has a reason to make end the process with SIGSYS. A worker
/// can still start threads, allocate memory, compile shaders, and use the files that Landlock allows.
class CallFilter {
  public:
    /// \param gpu also allow the ioctls of graphics cards
    /// \throws Error backend when the filter can't be made
    explicit CallFilter(bool gpu);

    /// Applies to the calling thread and all threads and processes that it starts later. Allocates nothing, so it may
    /// run between fork and exec. The thread must have set PR_SET_NO_NEW_PRIVS. The calls that a worker needs to start
    /// stay allowed until block_startup_calls.
    /// \returns whether it succeeded
    bool enforce() const;

  private:
    std::vector<sock_filter> program_;
};

/// Gives up, for all threads of this process, the calls that a CallFilter allows only for startup: execve and seccomp.
/// Signals to other processes are denied too.
/// \returns whether it succeeded
bool block_startup_calls();

}  // namespace vvr::workers
