#include <string>
#include <vector>

#include <unistd.h>

#include "cli/commands/command.h"
#include "cli/exit_status.h"
#include "cli/log.h"
#include "cli/signals.h"
#include "cli/workers/worker.h"
#include "core/base/memory.h"
#include "gl/context.h"

int main(int argc, char** argv) {
    vvr::workers::begin_worker();
    vvr::cli::install_terminate_handler();
    vvr::tune_malloc();
    vvr::gl::choose_shader_cache();
    const auto log = vvr::cli::make_log();
    const vvr::cli::ExitStatus status = vvr::cli::report_errors(*log, [&] {
        vvr::cli::Signals signals;
        const std::vector<std::string> arguments(argv + 1, argv + argc);
        return vvr::commands::run_command(arguments, vvr::cli::Environment{*log, signals});
    });
    // A library that could not be loaded for want of memory leaves the loader locked, for which its end would wait.
    if (status == vvr::cli::ExitStatus::limit) ::_exit(static_cast<int>(status));
    return static_cast<int>(status);
}
