#include "cli/render_job.h"

#include "core/error.h"

namespace vvr {

void add_options(CLI::App& app, RenderJob& job) {
    add_options(app, job.input);
    add_options(app, job.fields);
    add_options(app, job.bricks);
    add_options(app, job.view);
    add_options(app, job.look);
    add_options(app, job.backend);
    add_options(app, job.run);
}

void check(const RenderJob& job) {
    const InputOptions& input = job.input;
    if (input.name.empty()) {
        throw Error(ErrorKind::usage, "no INPUT: give a video file, a folder of pictures, or - for stdin");
    }
    if (input.start && input.end && input.start->unit == input.end->unit && input.start->value >= input.end->value) {
        throw Error(ErrorKind::usage, "--end has to come after --start");
    }
}

}  // namespace vvr
