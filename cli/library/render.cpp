#include "cli/app/render.h"

#include <mutex>
#include <span>
#include <string_view>
#include <utility>

#include <vvr/render.h>

#include <fmt/format.h>

#include "cli/app/input.h"
#include "cli/library/as_failure.h"
#include "cli/library/image_of.h"
#include "cli/options/job_options.h"

namespace vvr {

namespace {

/// Keeps what a person should know.
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

/// What the command line has beside settings.
constexpr std::string_view not_settings[] = {"help", "config", "no-config"};

/// Settings as the command line takes them. It has the tables of names, the checks and the texts of errors.
std::vector<std::string> arguments_of(const Settings& settings) {
    std::vector<std::string> arguments{"--no-config"};
    for (const auto& [name, value] : settings) {
        for (const std::string_view other : not_settings) {
            if (name == other) throw Error(ErrorKind::usage, fmt::format("'{}' is not a setting; leave it out", name));
        }
        // A name is told from its value by the first `=`, which must not be one of its own: "config=/x".
        const bool plain =
            !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
        if (!plain) {
            throw Error(ErrorKind::usage,
                        fmt::format("'{}' is no name of a setting; it has small letters, digits and -", name));
        }
        arguments.push_back(fmt::format("--{}={}", name, value));
    }
    return arguments;
}

app::RenderJob job_of(const std::string& clip, const Settings& settings) {
    app::RenderJob job;
    options::CommandLine line("render", "");
    options::add_input_options(line, job.input, "INPUT", "");
    options::add_name_options(line, job.input);
    options::add_join_option(line, job.input);
    options::add_picture_options(line, job);
    line.parse(arguments_of(settings));
    job.input.names = {clip};
    app::require_input(job.input);
    options::finish(line, job, false);
    return job;
}

}  // namespace

Rendering render_image(const std::string& clip, const Settings& settings) {
    return as_failure([&] {
        Warnings warnings;
        Rendering done;
        const app::RenderReport report = app::render(
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
