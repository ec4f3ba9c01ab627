#pragma once

#include <vector>

#include <linux/filter.h>

namespace vvr {

/// Why this kernel has no filters of system calls (seccomp), as in errno; 0 = it has them.
int why_no_call_filter();

/// The system calls that a worker gives up for good: they fail with an error. It still starts threads, takes memory,
/// also to compile shaders into, and uses the files that it is allowed.
class CallFilter {
  public:
    /// \throws Error limit when it can't be made
    CallFilter();

    /// Holds for the calling thread and for what it starts from now on. Allocates nothing, so it may stand between fork
    /// and exec. The thread must have given up new privileges (PR_SET_NO_NEW_PRIVS).
    /// \returns whether it does
    bool enforce() const;

  private:
    std::vector<sock_filter> program_;
};

}  // namespace vvr
