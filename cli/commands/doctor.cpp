#include <algorithm>

#include <fmt/format.h>

#include "cli/commands/command.h"
#include "cli/options/job_options.h"
#include "cli/print.h"
#include "cli/versions.h"
#include "gl/context.h"

namespace vvr {

namespace {

std::string describe(const BackendReport& report) {
    std::string text =
        fmt::format("{:<14} {}: {}\n", report.name, report.works ? "works" : "does not work", report.what);
    const auto line = [&text](const std::string& name, const std::string& value) {
        if (!value.empty()) text += fmt::format("    {:<10} {}\n", name, value);
    };
    line("renderer", report.renderer);
    line("version", report.version);
    line("reason", report.reason);
    line("fix with", report.advice);
    for (std::size_t i = 0; i < report.devices.size(); ++i) line(fmt::format("device {}", i), report.devices[i]);
    return text;
}

class Doctor final : public Command {
  public:
    void add_options(CommandLine& line) override { add_thread_options(line, threads_); }

    ExitStatus run(const CommandLine&, const Environment& environment) override {
        std::string text = version_text();
        const std::vector<BackendReport> reports = probe_backends();
        for (const BackendReport& report : reports) text += fmt::format("\n{}", describe(report));
        print(text);
        if (std::ranges::any_of(reports, &BackendReport::works)) return ExitStatus::done;
        environment.log.error("no backend works, so vvr can draw nothing here; the commands above fix it");
        return ExitStatus::backend;
    }

  private:
    int threads_ = 0;  // taken for config files that hold for all commands
};

}  // namespace

std::unique_ptr<Command> make_doctor() {
    return std::make_unique<Doctor>();
}

}  // namespace vvr
