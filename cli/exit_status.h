#pragma once

#include "core/base/error.h"

namespace vvr::cli {

/// What the program says to the shell. A run that SIGINT, SIGTERM or SIGHUP ends dies of that signal, which a shell
/// shows as 130, 143 or 129.
enum class ExitStatus {
    done = 0,
    usage = 1,      ///< the command line or a config file
    io = 2,         ///< a file can't be read or written
    not_video = 3,  ///< the input is not usable video
    backend = 4,    ///< no OpenGL backend, or OpenGL failed; or no sandbox where one is required
    limit = 5,      ///< out of memory, or over a stated limit
    partial = 6,    ///< some of several inputs failed
    differs = 7,    ///< a picture differs from its golden one, or there is none
    bug = 70,       ///< an error that vvr should have foreseen
};

ExitStatus exit_status(ErrorKind kind);

}  // namespace vvr::cli
