#include "cli/options/run.h"

#include "cli/log.h"
#include "cli/options/option.h"
#include "gl/context.h"

namespace vvr {

void add_options(CLI::App& app, RunOptions& options) {
    add_integer(app, group::run, options.threads, 0, 1024,
                {"--threads", "COUNT", "", "threads; 0 = one for each core"});
    add_talk_options(app, options);
}

void add_talk_options(CLI::App& app, RunOptions& options) {
    app.add_flag("-q,--quiet", options.quiet, "say nothing unless it fails")->group(group::run);
    app.add_flag("-v,--verbose", options.verbose, "say more")->group(group::run)->excludes("--quiet");
    add_text(
        app, group::run, options.log_file,
        {"--log-file", "FILE", "", "every line goes there too, with its time, whatever --quiet says; appended to"});
    add_name(app, group::run, options.log_format, names_of(log_formats()),
             {"--log-format", "NAME", "", "lines for people, or one JSON object each"});
}

void add_options(CLI::App& app, BackendOptions& options) {
    add_name(app, group::run, options.backend, backend_names(), {"--backend", "NAME", "", "which OpenGL draws"});
    add_integer(app, group::run, options.device, -1, 255,
                {"--device", "NUMBER", "", "EGL device as `vvr doctor` numbers them; -1 = the first that works"});
}

void apply(const RunOptions& options, spdlog::logger& log) {
    if (options.quiet) set_talk(log, Talk::quiet);
    if (options.verbose) set_talk(log, Talk::verbose);
    set_format(log, options.log_format);
    if (!options.log_file.empty()) add_file(log, options.log_file, options.log_format);
}

}  // namespace vvr
