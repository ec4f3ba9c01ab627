#include "cli/options/archive.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "cli/commands/command.h"
#include "cli/options/job_options.h"
#include "cli/app/open_fields.h"
#include "cli/app/settings.h"
#include "core/archive/names.h"
#include "core/base/read_file.h"
#include "core/base/sha256.h"
#include "gl/context.h"

namespace vvr {

namespace {

/// What workers draw with is told to them, and changes no picture.
constexpr std::array drawn_with{setting::backend.name, setting::device.name, setting::gl_debug.name};

/// Of everything that makes the files what they are. Not of vvr's version: a new one is no reason to draw years again.
std::string digest_of(const CommandLine& line, const ArchiveOptions& options) {
    std::string text;
    for (const Group group : picture_groups) {
        for (const OptionValue& value : line.values(std::span(&group, 1))) {
            if (value.value.empty()) continue;
            text += fmt::format("{}={}\n", value.name, value.shown());
            std::error_code none;
            if (value.may_be_file && std::filesystem::is_regular_file(value.value, none))
                text += read_file(value.value);
        }
    }
    for (const OutputRow& row : output_rows) {
        if (row.kind != OutputKind::page || !options.no_pages)
            text += fmt::format("file {}\n", static_cast<int>(row.kind));
    }
    std::string digest;
    for (const std::byte byte : sha256(text)) digest += fmt::format("{:02x}", std::to_integer<int>(byte));
    return digest;
}

class Archive final : public Command {
  public:
    void add_options(CommandLine& line) override {
        add_archive_options(line, options_);
        add_input_options(line, job_.input, "CLIPS", "the folder that holds the clips, in folders of its own or not");
        add_layout_options(line, job_.input);
        add_picture_options(line, job_);
        line.examples({{"vvr archive clips -o pictures --dry-run", "what would be done, and why"},
                       {"vvr archive clips -o pictures --prune --quiet",
                        "for cron: draw what is new, remove what is gone, print what failed"},
                       {"vvr archive recordings -o days --per day", "a picture per camera and day"}});
    }

    ExitStatus run(const CommandLine& line, const Environment& environment) override {
        if (!job_.input.names.empty()) options_.in = only_input(job_.input);
        check(options_);
        finish(line, job_, false);
        if (!options_.index_only) validate(job_);
        options_.settings = digest_of(line, options_);
        for (const OptionValue& value : line.given(picture_groups)) {
            if (value.name != setting::names.name) pass_on(value);
        }
        for (const std::string& layout : job_.input.layouts) {
            pass_on({std::string(setting::names.name), layout});
        }
        for (const OptionValue& value : line.given(std::array{Group::run})) {
            if (std::ranges::find(drawn_with, value.name) == drawn_with.end()) continue;
            std::string passed = pass_on(value);
            if (value.name != setting::gl_debug.name) options_.drawn_with.push_back(std::move(passed));
        }
        options_.needs.gpu = may_use_gpu(job_.backend.name);
        options_.names = job_.input.layouts;
        options_.threads = job_.fields.threads;
        return run_archive(options_, environment);
    }

  private:
    std::string pass_on(const OptionValue& value) {
        if (value.may_be_file) options_.needs.files.emplace_back(value.value);
        return options_.worker_options.emplace_back(fmt::format("--{}={}", value.name, value.value));
    }

    ArchiveOptions options_;
    RenderJob job_;
};

}  // namespace

std::unique_ptr<Command> make_archive() {
    return std::make_unique<Archive>();
}

}  // namespace vvr
