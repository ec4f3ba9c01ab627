#pragma once

#include <fstream>
#include <string>

#include <malloc.h>

#include "core/base/error.h"

namespace vvr::bench {

/// The most memory that this process held at a time since this was made, beyond what it held then. Linux only: a
/// process may set its own high-water mark back there. What a GPU holds isn't in it.
class PeakMemory {
  public:
    PeakMemory() {
        malloc_trim(0);  // else what others have freed would be used before anything shows
        std::ofstream reset("/proc/self/clear_refs");
        reset << "5" << std::flush;
        if (!reset) {
            throw Error(ErrorCode::io,
                        "/proc/self/clear_refs can't be written, by which a process sets its peak of memory back; this "
                        "measures memory where Linux lets it, so run it outside of whatever takes /proc away");
        }
        before_ = kilobytes("VmRSS:");
    }

    double megabytes() const { return static_cast<double>(kilobytes("VmHWM:") - before_) / 1024; }

  private:
    static long kilobytes(const std::string& row) {
        std::ifstream status("/proc/self/status");
        for (std::string line; std::getline(status, line);) {
            if (line.starts_with(row)) return std::stol(line.substr(row.size()));
        }
        throw Error(ErrorCode::io, "/proc/self/status has no row " + row + "; this measures memory on Linux only");
    }

    long before_ = 0;
};

}  // namespace vvr::bench
