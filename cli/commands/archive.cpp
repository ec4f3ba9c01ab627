#include "cli/workers/archive.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands/command.h"
#include "cli/observe/identify.h"
#include "cli/options/command_line.h"
#include "cli/options/job_options.h"
#include "cli/plan/input.h"
#include "cli/plan/settings.h"
#include "core/archive/output_files.h"
#include "core/base/digest.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/fields/filter.h"
#include "core/footage/input_files.h"
#include "gl/context.h"

namespace vvr::commands {

namespace {

namespace archive_rows {
constexpr Setting output{"output", "DIR", "folder for pictures, pages and their "};
constexpr Setting match{
    "match", "GLOB",
    "pattern of the clips: *.avi, or with folders cam?/*.avi; may be repeated; default: files that end in "};
constexpr Setting exclude{"exclude", "GLOB", "pattern of files to leave out; may be repeated"};
constexpr Setting per{"per", "NAME", "one picture per clip, day or night"};
constexpr Setting day_begins{
    "day-begins",
    "HH:MM",
    "when days begin; days that begin at 12:00 or later are nights, with the date of their evening",
    {},
    "00:00; night: 12:00"};
constexpr Setting part{"part", "I/N", "draw only part I of N of the clips, 1/N to N/N"};
constexpr Setting dry_run{"dry-run", "", "print what a run would do, and why; draw nothing"};
constexpr Setting prune{"prune", "", "remove the pictures of deleted clips"};
constexpr Setting keep{
    "keep",
    "AGE",
    "remove pictures, pages and their files of clips last written longer ago than this, for example 30d; "
    "older clips are not drawn",
    {},
    "for ever"};
constexpr Setting keep_events{
    "keep-events", "",
    "also copy each event to a piece of video beside its page, which plays it when the clip is gone"};
constexpr Setting margin{"margin", "TIME", "with --keep-events: additional time before and after an event", {0, 3600}};
constexpr Setting write{"write", "LIST", "what a run writes"};
constexpr Setting events_csv{
    "events-csv", "FILE",
    "the events of all clips as a table with commas, one line per event, and one for a clip without events"};
constexpr Setting jobs{"jobs",
                       "COUNT",
                       "number of clips drawn at the same time, each in its own process",
                       {1, 1024},
                       "cores / --threads, less if memory is short"};
constexpr Setting timeout{"timeout", "TIME", "maximum time per clip; 0 = no limit"};
constexpr Setting max_memory{
    "max-memory", "BYTES", "memory limit per clip, for example 2G", {}, "80 % of the memory / --jobs, at least 2G"};
constexpr Setting sandbox{"sandbox", "NAME", "restrict each worker to its own clip and pictures"};
}  // namespace archive_rows

void add_archive_options(options::CommandLine& line, workers::ArchiveOptions& archive,
                         std::optional<std::pair<int, int>>& part) {
    const options::AddOptions add(line, options::Group::archive);
    add(archive_rows::output, archive.out,
        {.letter = 'o',
         .help = fmt::format("{}; created if missing", archive::index_name),
         .use = options::FileUse::filled});
    add(archive_rows::match, archive.match, {.help = fmt::format("{}", fmt::join(footage::video_extensions(), " "))});
    add(archive_rows::exclude, archive.exclude);
    add(archive_rows::per, archive.per, workers::groupings, &workers::GroupingRow::grouping);
    add(archive_rows::day_begins, archive.day);
    add(archive_rows::part, part);
    add(archive_rows::dry_run, archive.dry_run);
    add(archive_rows::prune, archive.prune);
    add(archive_rows::keep, archive.keep);
    add(archive_rows::keep_events, archive.keep_events);
    add(archive_rows::margin, archive.margin);
    add(archive_rows::write, archive.write, workers::outputs_rows, &workers::OutputsRow::kind);
    options::add_events_to_option(line, options::Group::archive, archive.events_to);
    add(archive_rows::events_csv, archive.events_csv, {.use = options::FileUse::written});
    const options::AddOptions add_worker(line, options::Group::workers);
    add_worker(archive_rows::jobs, archive.jobs);
    add_worker(archive_rows::timeout, archive.timeout);
    add_worker(archive_rows::max_memory, archive.max_memory);
    add_worker(archive_rows::sandbox, archive.sandbox, workers::sandbox_modes, &workers::SandboxRow::mode);
}

/// \throws Error usage when options contradict each other
void check(const workers::ArchiveOptions& options) {
    if (options.out.empty())
        throw Error(ErrorCode::output_missing, "no output given; name the folder for the pictures with -o DIR");
    if (options.keep && *options.keep < std::chrono::hours(1)) {
        throw Error(ErrorCode::option_value_out_of_range,
                    "keep: files are kept for at least an hour; give a longer time, for example 30d",
                    {archive_rows::keep.name});
    }
    if (options.keep_events && options.prune) {
        throw Error(ErrorCode::options_conflict,
                    "--prune removes the pieces of deleted clips, which --keep-events is to keep; drop --prune, and "
                    "remove files by age with --keep AGE",
                    {archive_rows::keep_events.name});
    }
    if (!options.draws() && (options.prune || options.keep || options.dry_run)) {
        throw Error(ErrorCode::options_conflict,
                    fmt::format("--write index writes only the index; drop {}", options.prune  ? "--prune"
                                                                                : options.keep ? "--keep"
                                                                                               : "--dry-run"));
    }
    if (!options.draws() && !options.events_to.empty()) {
        throw Error(ErrorCode::options_conflict,
                    "--write index draws nothing, so there are no new events; drop --events-to");
    }
    if (options.day && !options.grouping().days) {
        throw Error(ErrorCode::options_conflict,
                    "--per clip has no days; drop --day-begins, or choose --per day or night",
                    {archive_rows::day_begins.name});
    }
    if (options.per == workers::Grouping::night && !options.day_rule().is_night()) {
        throw Error(ErrorCode::options_conflict,
                    "a night begins at 12:00 or later; give a later --day-begins, or choose --per day",
                    {archive_rows::day_begins.name});
    }
    constexpr std::int64_t least_memory = 200'000'000;  // what a worker needs for the smallest clip
    if (options.max_memory && *options.max_memory < least_memory) {
        throw Error(ErrorCode::option_value_out_of_range,
                    fmt::format("max-memory: '{}' is less than a worker needs to start; give at least 200M, or 1G "
                                "for most clips",
                                *options.max_memory),
                    {archive_rows::max_memory.name});
    }
    if (options.in.empty() && options.draws()) {
        throw Error(ErrorCode::input_missing, "no INPUT given; name the folder of the clips");
    }
}

/// What selects OpenGL and the decoder. Workers get it, but it changes no picture.
constexpr std::array drawn_with{setting::backend.name, setting::hwaccel.name};

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
        if (row.kind != archive::OutputKind::page || options.writes(workers::Outputs::pages))
            text += fmt::format("file {}\n", static_cast<int>(row.kind));
    }
    if (options.keep_events) text += fmt::format("pieces {}\n", options.margin);
    return hex_sha256(text);
}

/// Refuses folders of fields, flows or seeds: they are of one clip.
void refuse_folders_of_one_clip(const options::CommandLine& line) {
    for (const options::OptionValue& value : line.given(options::picture_groups)) {
        std::error_code none;
        if (!value.may_be_file || !std::filesystem::is_directory(value.value, none)) continue;
        throw Error(ErrorCode::options_conflict,
                    fmt::format("--{}: the folder '{}' belongs to one clip and can't fit all clips of an archive; draw "
                                "its clip with: vvr render CLIP --{} '{}'",
                                value.name, value.value, value.name, value.value),
                    {value.name});
    }
}

class Archive final : public Command {
  public:
    void add_options(options::CommandLine& line) override {
        add_archive_options(line, options_, part_);
        options::add_input_options(line, job_.input, "CLIPS",
                                   "the folder of the clips; vvr also searches its subfolders");
        options::add_name_options(line, job_.input);
        options::add_decode_option(line, job_.input);
        options::add_picture_options(line, job_);
        line.examples({{"vvr archive clips -o pictures --dry-run", "what a run would do, and why"},
                       {"vvr archive clips -o pictures --prune --quiet",
                        "for cron: draw new clips, remove pictures of deleted ones, print failures"},
                       {"vvr archive recordings -o days --per day", "one picture per camera and day"},
                       {"vvr archive recordings -o nights --per night", "one picture per camera and night"},
                       {"vvr archive clips -o pictures --keep-events --keep 30d",
                        "keep events as video for a month, even if the clips are overwritten"}});
    }

    cli::ExitStatus run(const options::CommandLine& line, const cli::Environment& environment) override {
        if (!job_.input.names.empty()) options_.in = app::only_input(job_.input);
        check(options_);
        if (!options_.keep_events && line.is_argument(archive_rows::margin.name)) {
            throw Error(ErrorCode::option_needs_another,
                        "--margin needs --keep-events, the pieces to which it adds time", {archive_rows::margin.name});
        }
        if (part_) {
            options_.shard = {static_cast<std::uint64_t>(part_->first - 1), static_cast<std::uint64_t>(part_->second)};
        }
        options_.pictures = pictures_of(line);
        for (const std::string& camera : line.cameras()) {
            CommandAndLine own(find_command("archive"));
            own.line.parse_for_camera(line, camera);
            auto& archive = static_cast<Archive&>(*own.command);
            archive.options_.write = options_.write;
            archive.options_.keep_events = options_.keep_events;
            archive.options_.margin = options_.margin;
            options_.of_cameras.emplace(camera, archive.pictures_of(own.line));
            const std::vector<std::filesystem::path>& files = archive.options_.needs.files;
            options_.needs.files.insert(options_.needs.files.end(), files.begin(), files.end());
        }
        for (const options::OptionValue& value : line.given(std::array{options::Group::run})) {
            if (std::ranges::find(drawn_with, value.name) == drawn_with.end()) continue;
            for (auto& [camera, pictures] : options_.of_cameras) pass_on(value, pictures);
            pass_on(value, options_.pictures);
            options_.drawn_with.emplace_back(value.name, value.value);
        }
        const bool decodes_on_gpu = job_.input.hwaccel->device != AV_HWDEVICE_TYPE_NONE;
        options_.needs.gpu = gl::may_use_gpu(*job_.backend.row) || decodes_on_gpu;
        options_.threads = job_.fields.threads;
        return workers::run_archive(options_, environment);
    }

  private:
    /// What pictures are drawn with, after a check.
    workers::PictureSettings pictures_of(const options::CommandLine& line) {
        options::finish(line, job_, false);
        refuse_folders_of_one_clip(line);
        if (options_.draws()) {
            app::validate(job_);
            const fields::FilterRow& filter = *job_.fields.filter;
            if (options_.keep_events && !filter.traits.shows_object) {
                throw Error(ErrorCode::options_conflict,
                            fmt::format("filter '{}' does not mark objects, so there are no events to keep; choose "
                                        "another filter, or drop --keep-events",
                                        filter.name),
                            {"filter", archive_rows::keep_events.name});
            }
            options::check_events_to(options_.events_to, job_);
            app::open_detector(job_.detector);
        }
        workers::PictureSettings pictures;
        pictures.digest = digest_of(line, options_);
        pictures.names = job_.input.name_patterns;
        for (const options::OptionValue& value : line.given(options::picture_groups)) {
            if (value.name != setting::names.name) pass_on(value, pictures);
        }
        for (const std::string& pattern : pictures.names)
            pass_on({std::string(setting::names.name), pattern}, pictures);
        return pictures;
    }

    void pass_on(const options::OptionValue& value, workers::PictureSettings& pictures) {
        if (value.may_be_file) options_.needs.files.emplace_back(value.value);
        pictures.settings.emplace_back(value.name, value.value);
    }

    workers::ArchiveOptions options_;
    std::optional<std::pair<int, int>> part_;  ///< I of N, from 1; none = all clips
    app::RenderJob job_;
};

}  // namespace

std::unique_ptr<Command> make_archive() {
    return std::make_unique<Archive>();
}

}  // namespace vvr::commands
