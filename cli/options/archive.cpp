#include "cli/options/archive.h"

#include <fmt/format.h>

#include "cli/options/option.h"
#include "core/archive/clip_names.h"
#include "core/archive/names.h"

namespace vvr {

namespace {

void add_flag(CLI::App& app, const char* group, bool& target, const std::string& name, const std::string& help) {
    app.add_flag(name, target, help)->group(group);
}

}  // namespace

void add_options(CLI::App& app, ArchiveOptions& options) {
    constexpr const char* clips = group::archive;
    add_option(app, clips, options.out,
               {"-o,--output", "DIR", "",
                fmt::format("where pictures, pages and their {} go; made if it isn't there", index_name)},
               [](const std::string& given) { return std::filesystem::path(given); });
    app.add_option(
           "--match", options.match,
           fmt::format("which files are clips: *.avi, or with folders cam?/*.avi; can be given several times; if "
                       "not given, those that end in {}",
                       fmt::join(video_endings(), " ")))
        ->type_name("GLOB")
        ->group(clips)
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add_option(app, clips, options.settle,
               {"--settle", "TIME", "60s", "files that changed less than this ago are still being written, and left"},
               parse_duration);
    add_integer(app, clips, options.tries, 1, 1000,
                {"--tries", "COUNT", "", "how often, run after run, a clip that fails is tried"});
    add_option(app, clips, options.shard, {"--shard", "I/N", "", "only this share of the clips, 1/N to N/N"},
               [](const std::string& given) {
                   const auto [share, count] = parse_share(given);
                   return Shard{static_cast<std::uint64_t>(share - 1), static_cast<std::uint64_t>(count)};
               });
    add_flag(app, clips, options.dry_run, "--dry-run", "print what would be done, and why, and do nothing");
    add_flag(app, clips, options.prune, "--prune", "remove the pictures of clips that have gone");
    add_flag(app, clips, options.index_only, "--index-only", "write the index and draw nothing");
    add_flag(app, clips, options.no_index, "--no-index", "write no index");
    add_flag(app, clips, options.no_pages, "--no-pages", "pictures only, which is quicker");
    add_integer(app, group::workers, options.jobs, 1, 1024,
                {"--jobs", "COUNT", "as many as cores and memory allow", "clips at a time, a process each"});
    add_option(app, group::workers, options.timeout,
               {"--timeout", "TIME", "2h", "the longest that a clip may take; 0 = any"}, parse_duration);
    add_option(app, group::workers, options.max_memory,
               {"--max-memory", "BYTES", "its share of the machine's", "the most memory that a clip may take, 2G say"},
               parse_bytes);
}

void check(const ArchiveOptions& options) {
    if (options.out.empty()) throw Error(ErrorKind::usage, "no output: say where the pictures go with -o DIR");
    if (options.index_only && (options.no_index || options.prune || options.dry_run)) {
        throw Error(ErrorKind::usage, fmt::format("--index-only writes the index and nothing else; leave out {}",
                                                  options.no_index ? "--no-index"
                                                  : options.prune  ? "--prune"
                                                                   : "--dry-run"));
    }
    if (options.in.empty() && !options.index_only) {
        throw Error(ErrorKind::usage, "no INPUT: give the folder that holds the clips");
    }
}

}  // namespace vvr
