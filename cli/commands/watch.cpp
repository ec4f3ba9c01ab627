#include "cli/options/watch.h"

#include <algorithm>

#include <fmt/format.h>

#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/options/job_options.h"
#include "cli/render/open_fields.h"
#include "core/error.h"
#include "core/fields/reference.h"

namespace vvr {

namespace {

class Watch final : public Command {
  public:
    Watch() {
        // A reference that needs the whole clip would have to wait for the end.
        job_.fields.reference = std::ranges::find_if(reference_kinds(), &ReferenceRow::adapts)->name;
    }

    void add_options(CommandLine& line) override {
        add_stream_output(line, job_.output);
        add_stream_options(line, options_);
        add_input_options(line, job_.input, "a URL, a camera's device, a file that grows, - for stdin");
        add_picture_options(line, job_);
    }

    ExitStatus run(const CommandLine& line, const Environment& environment) override {
        check_stream(line, job_);
        only_input(job_.input);
        finish(line, job_, true);
        Console console(environment, false);
        StreamWatch watch(job_, options_, console);
        const PoliteStop stop(environment.signals, [&watch] { watch.stop(); });
        if (watch.run() == 0 && !stop.asked()) {
            const ReferenceRow* const reference = find_reference(job_.fields.reference);
            const bool learns = reference != nullptr && reference->adapts;
            throw Error(ErrorKind::not_video,
                        fmt::format("'{}' ended before the first picture: {}", watch.name(),
                                    learns ? "its first two seconds only show what the empty scene is; watch it for "
                                             "longer, or take --reference first or a picture"
                                           : "watch it for longer, or take a shorter --brick"));
        }
        return ExitStatus::done;
    }

  private:
    RenderJob job_;
    StreamOptions options_;
};

}  // namespace

std::unique_ptr<Command> make_watch() {
    return std::make_unique<Watch>();
}

}  // namespace vvr
