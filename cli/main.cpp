#include <string>
#include <vector>

#include <unistd.h>

#include "cli/commands/command.h"
#include "cli/exit_status.h"
#include "cli/log.h"
#include "cli/shader_cache.h"
#include "cli/signals.h"
#include "cli/workers/worker_message.h"
#include "core/base/memory.h"

int main(int argc, char** argv) {
    const auto parent = vvr::workers::begin_worker();
    vvr::cli::install_terminate_handler();
    vvr::tune_malloc();
    vvr::cli::choose_shader_cache();
    const auto log = vvr::cli::make_log();
    const auto warnings = parent ? vvr::cli::keep_warnings(*log, vvr::workers::most_warnings) : nullptr;
    const vvr::cli::Outcome outcome = vvr::cli::report_errors(*log, [&] {
        vvr::cli::Signals signals;
        vvr::cli::Environment environment{*log, signals};
        if (parent) environment.progress = vvr::workers::ProgressToParent(*parent);
        if (parent) return vvr::commands::run_plan(vvr::workers::read_plan(), environment);
        return vvr::commands::run_command(std::vector<std::string>(argv + 1, argv + argc), environment);
    });
    if (parent) vvr::workers::send_to_parent(*parent, {outcome.code, outcome.text, warnings()});
    // Don't run the exit handlers: a library that failed to load for lack of memory leaves the loader locked.
    if (outcome.status == vvr::cli::ExitStatus::limit) ::_exit(static_cast<int>(outcome.status));
    return static_cast<int>(outcome.status);
}
