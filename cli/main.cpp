#include <string>
#include <vector>

#include <unistd.h>

#include "cli/commands/command.h"
#include "cli/log.h"
#include "cli/report_errors.h"
#include "cli/signals.h"
#include "cli/workers/worker_begin.h"
#include "core/base/machine_memory.h"
#include "gl/shader_cache.h"

int main(int argc, char** argv) {
    vvr::begin_worker();
    vvr::end_in_good_order();
    vvr::keep_freed_planes();
    vvr::choose_shader_cache();
    const auto log = vvr::make_log();
    const vvr::ExitStatus status = vvr::report_errors(*log, [&] {
        vvr::Signals signals;
        const std::vector<std::string> arguments(argv + 1, argv + argc);
        return vvr::run_command(arguments, vvr::Environment{*log, signals});
    });
    // A library that could not be loaded for want of memory leaves the loader locked, for which its end would wait.
    if (status == vvr::ExitStatus::limit) ::_exit(static_cast<int>(status));
    return static_cast<int>(status);
}
