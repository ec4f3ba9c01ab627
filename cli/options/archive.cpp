#include "cli/options/archive.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/options/parse_value.h"
#include "core/archive/output_files.h"
#include "core/base/error.h"
#include "core/video/input_files.h"

namespace vvr::options {

namespace {

namespace text {
constexpr Setting output{"output", "DIR", "folder for pictures, pages and their "};
constexpr Setting match{"match", "GLOB",
                        "which files are clips: *.avi, or with folders cam?/*.avi; can be given several times; if not "
                        "given, those that end in "};
constexpr Setting exclude{"exclude", "GLOB", "which of these are not; can be given several times"};
constexpr Setting per{"per", "NAME", "what gets a picture"};
constexpr Setting redraw{"redraw", "TIME", "redraw a day after this much new footage, or this long without any"};
constexpr Setting settle{"settle", "TIME", "skip files that changed less than this ago: they are still being written"};
constexpr Setting tries{"tries", "COUNT", "number of runs in which a clip that fails is tried", {1, 1000}};
constexpr Setting shard{"shard", "I/N", "only this share of the clips, 1/N to N/N"};
constexpr Setting dry_run{"dry-run", "", "print what would be done, and why, and do nothing"};
constexpr Setting prune{"prune", "", "remove the pictures of clips that are gone"};
constexpr Setting index_only{"index-only", "", "write the index and draw nothing"};
constexpr Setting no_index{"no-index", "", "write no index"};
constexpr Setting no_pages{"no-pages", "", "pictures only, which is faster"};
constexpr Setting jobs{
    "jobs", "COUNT", "clips at the same time, a process each", {1, 1024}, "cores / --threads, less if memory is short"};
constexpr Setting timeout{"timeout", "TIME", "the longest time that a clip may take; 0 = no limit"};
constexpr Setting max_memory{
    "max-memory", "BYTES", "memory limit of a clip, for example 2G", {}, "the machine's / --jobs, at least 2G"};
constexpr Setting sandbox{"sandbox", "NAME", "restrict each worker to its clip and its pictures"};
}  // namespace text

}  // namespace

void add_archive_options(CommandLine& line, workers::ArchiveOptions& options) {
    constexpr Group archive = Group::archive;
    constexpr Group workers = Group::workers;
    line.path(archive, options.out, text::output,
              {.letter = 'o', .help = fmt::format("{}; it is made if it isn't there", archive::index_name)});
    line.list(archive, options.match, text::match,
              {.help = fmt::format("{}", fmt::join(video::video_extensions(), " "))});
    line.list(archive, options.exclude, text::exclude);
    line.choice(archive, workers::groupings, workers::groupings.front().name, text::per,
                [&options](const workers::GroupingRow& row) { options.per = row.grouping; });
    line.value(archive, text::redraw, "15m",
               [&options](const std::string& given) { options.redraw = parse_whole_seconds(given); });
    line.value(archive, text::settle, "60s",
               [&options](const std::string& given) { options.settle = parse_whole_seconds(given); });
    line.number(archive, options.tries, text::tries);
    line.value(archive, text::shard, "", [&options](const std::string& given) {
        const auto [share, count] = parse_share(given);
        options.shard = {static_cast<std::uint64_t>(share - 1), static_cast<std::uint64_t>(count)};
    });
    line.flag(archive, options.dry_run, text::dry_run);
    line.flag(archive, options.prune, text::prune);
    line.flag(archive, options.index_only, text::index_only);
    line.flag(archive, options.no_index, text::no_index);
    line.flag(archive, options.no_pages, text::no_pages);
    line.number(workers, options.jobs, text::jobs);
    line.value(workers, text::timeout, "2h",
               [&options](const std::string& given) { options.timeout = parse_whole_seconds(given); });
    line.value(workers, text::max_memory, std::string(text::max_memory.default_text),
               [&options](const std::string& given) {
                   constexpr std::int64_t least = 200'000'000;  // what a worker needs for the smallest clip
                   options.max_memory = parse_bytes(given);
                   if (*options.max_memory >= least) return;
                   throw Error(ErrorCode::option_value_out_of_range,
                               fmt::format("'{}' is less than a worker takes to start; give 200M at "
                                           "least, 1G for most clips",
                                           given));
               });
    line.choice(workers, workers::sandbox_modes, workers::sandbox_modes.front().name, text::sandbox,
                [&options](const workers::SandboxRow& row) { options.sandbox = row.mode; });
}

void check(const workers::ArchiveOptions& options) {
    if (options.out.empty()) throw Error(ErrorCode::output_missing, "no output: say where the pictures go with -o DIR");
    if (options.index_only && (options.no_index || options.prune || options.dry_run)) {
        throw Error(
            ErrorCode::options_conflict,
            fmt::format("--index-only writes the index and nothing else; leave out {}", options.no_index ? "--no-index"
                                                                                        : options.prune  ? "--prune"
                                                                                                        : "--dry-run"));
    }
    if (options.in.empty() && !options.index_only) {
        throw Error(ErrorCode::input_missing, "no INPUT: give the folder that holds the clips");
    }
}

}  // namespace vvr::options
