#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <malloc.h>

#include "cli/commands/command.h"
#include "cli/log.h"
#include "cli/report_errors.h"
#include "cli/signals.h"

namespace {

/// Planes come and go by the frame. Without this the C library gives each back to the system, and takes it again page
/// by page.
void keep_freed_memory() {
    constexpr int larger_than_a_plane = 32 << 20;
    // One heap for all threads: planes are given back by others than those that took them, and each heap would keep its
    // own.
    mallopt(M_ARENA_MAX, 1);
    mallopt(M_MMAP_THRESHOLD, larger_than_a_plane);
    mallopt(M_TRIM_THRESHOLD, 4 * larger_than_a_plane);
    mallopt(M_TOP_PAD, larger_than_a_plane / 4);
}

}  // namespace

int main(int argc, char** argv) {
    keep_freed_memory();
    const auto log = vvr::make_log();
    const auto status = vvr::report_errors(*log, [&] {
        vvr::Signals signals;
        const std::vector<std::string> arguments(argv + 1, argv + argc);
        return vvr::run_command(arguments, vvr::Environment{*log, signals});
    });
    // Without the destructors of 250 libraries, which run in the order in which these happened to be loaded while other
    // threads still hold what they made.
    std::fflush(nullptr);
    std::_Exit(static_cast<int>(status));
}
