#include "cli/options/archive.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "cli/app/input.h"
#include "cli/app/settings.h"
#include "cli/commands/command.h"
#include "cli/options/job_options.h"
#include "core/archive/output_files.h"
#include "core/base/digest.h"
#include "core/base/file.h"
#include "gl/context.h"

namespace vvr::commands {

namespace {

/// These settings select OpenGL. Workers get them, but they change no picture.
constexpr std::array drawn_with{setting::backend.name, setting::device.name, setting::gl_debug.name};

/// A digest of all settings that change the files. Without vvr's version: a new version must not redraw years of clips.
std::string digest_of(const options::CommandLine& line, const workers::ArchiveOptions& options) {
    std::string text;
    for (const options::Group group : options::picture_groups) {
        for (const options::OptionValue& value : line.values(std::span(&group, 1))) {
            if (value.value.empty()) continue;
            text += fmt::format("{}={}\n", value.name, value.shown());
            std::error_code none;
            if (value.may_be_file && std::filesystem::is_regular_file(value.value, none))
                text += read_file(value.value);
        }
    }
    for (const archive::OutputRow& row : archive::output_rows) {
        if (row.kind != archive::OutputKind::page || !options.no_pages)
            text += fmt::format("file {}\n", static_cast<int>(row.kind));
    }
    return hex_sha256(text);
}

class Archive final : public Command {
  public:
    void add_options(options::CommandLine& line) override {
        options::add_archive_options(line, options_);
        options::add_input_options(line, job_.input, "CLIPS",
                                   "the folder that holds the clips, in folders of its own or not");
        options::add_name_options(line, job_.input);
        options::add_picture_options(line, job_);
        line.examples({{"vvr archive clips -o pictures --dry-run", "what would be done, and why"},
                       {"vvr archive clips -o pictures --prune --quiet",
                        "for cron: draw what is new, remove what is gone, print what failed"},
                       {"vvr archive recordings -o days --per day", "a picture per camera and day"}});
    }

    cli::ExitStatus run(const options::CommandLine& line, const cli::Environment& environment) override {
        if (!job_.input.names.empty()) options_.in = app::only_input(job_.input);
        options::check(options_);
        options::finish(line, job_, false);
        if (!options_.index_only) app::validate(job_);
        options_.settings = digest_of(line, options_);
        for (const options::OptionValue& value : line.given(options::picture_groups)) {
            if (value.name != setting::names.name) pass_on(value);
        }
        for (const std::string& pattern : job_.input.name_patterns) {
            pass_on({std::string(setting::names.name), pattern});
        }
        for (const options::OptionValue& value : line.given(std::array{options::Group::run})) {
            if (std::ranges::find(drawn_with, value.name) == drawn_with.end()) continue;
            pass_on(value);
            if (value.name != setting::gl_debug.name) options_.drawn_with.emplace_back(value.name, value.value);
        }
        options_.needs.gpu = gl::may_use_gpu(*job_.backend.row);
        options_.names = job_.input.name_patterns;
        options_.threads = job_.fields.threads;
        return workers::run_archive(options_, environment);
    }

  private:
    void pass_on(const options::OptionValue& value) {
        if (value.may_be_file) options_.needs.files.emplace_back(value.value);
        options_.worker_settings.emplace_back(value.name, value.value);
    }

    workers::ArchiveOptions options_;
    app::RenderJob job_;
};

}  // namespace

std::unique_ptr<Command> make_archive() {
    return std::make_unique<Archive>();
}

}  // namespace vvr::commands
