#include "cli/app/render.h"

#include <mutex>
#include <span>
#include <utility>

#include <vvr/render.h>

#include "cli/app/input.h"
#include "cli/library/as_failure.h"
#include "cli/library/image_of.h"
#include "cli/options/job_options.h"

namespace vvr {

namespace {

/// Collects warnings.
class Warnings final : public app::Observer {
  public:
    void warn(const std::string& text, const RelatedSettings& /*about*/) override {
        const std::lock_guard lock(mutex_);
        texts_.push_back(text);
    }

    std::vector<std::string> take() { return std::move(texts_); }

  private:
    std::mutex mutex_;
    std::vector<std::string> texts_;
};

app::RenderJob job_of(const std::string& clip, const Settings& settings) {
    app::RenderJob job;
    options::CommandLine line("render", "");
    options::add_input_options(line, job.input, "INPUT", "");
    options::add_name_options(line, job.input);
    options::add_join_option(line, job.input);
    options::add_picture_options(line, job);
    line.take({clip}, settings);
    app::require_input(job.input);
    options::finish(line, job, false);
    return job;
}

}  // namespace

Rendering render_image(const std::string& clip, const Settings& settings) {
    return as_failure([&] {
        Warnings warnings;
        Rendering done;
        const app::RenderSummary report = app::render(
            job_of(clip, settings), warnings, [&done](const image::Picture& picture, const image::Metadata& record) {
                done.image = image_of(picture, record);
            });
        done.frames = report.frames;
        done.damaged = report.damaged;
        done.warnings = warnings.take();
        return done;
    });
}

}  // namespace vvr
