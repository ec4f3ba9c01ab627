#include <string>
#include <vector>

#include "cli/commands/command.h"
#include "cli/log.h"
#include "cli/report_errors.h"
#include "cli/signals.h"
#include "core/machine_memory.h"
#include "gl/shader_cache.h"

int main(int argc, char** argv) {
    vvr::keep_freed_planes();
    vvr::choose_shader_cache();
    const auto log = vvr::make_log();
    return static_cast<int>(vvr::report_errors(*log, [&] {
        vvr::Signals signals;
        const std::vector<std::string> arguments(argv + 1, argv + argc);
        return vvr::run_command(arguments, vvr::Environment{*log, signals});
    }));
}
