#include "core/fields/seeds.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "cli/commands/command.h"
#include "cli/commands/new_folder.h"
#include "cli/console.h"
#include "cli/options/command_line.h"
#include "cli/plan/observer.h"
#include "cli/signals.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/setting.h"
#include "core/base/text.h"
#include "core/dataset/stored_fields.h"
#include "core/fields/filter.h"
#include "core/fields/flo_file.h"
#include "core/fields/frame_files.h"
#include "core/fields/options.h"
#include "core/fields/seed_list.h"
#include "core/fields/settings.h"

namespace vvr::commands {

namespace {

/// A stored flow, and the folder for its seed lists.
struct StoredFlowSeedsJob {
    std::filesystem::path flow;  ///< an extraction, or a folder of .flo files whose names end in frame numbers
    std::filesystem::path folder;
    fields::SeedOptions seeds;
};

namespace fs = std::filesystem;

namespace seeds_text {
constexpr Setting output{"output", "DIR", "a new or empty folder for the lists; `vvr render --seeds DIR` reads them"};
}  // namespace seeds_text

/// Thrown between two lists, so that no folder is left.
struct Stopped {};

/// The lists of a run, which appear together or not at all.
class SeedFolder {
  public:
    SeedFolder(const fs::path& folder, std::string_view setting, std::stop_token stop)
        : folder_(folder, setting), stop_(std::move(stop)) {}

    /// \throws Stopped if the run is to stop; Error io
    void add(const fields::SeedList& list) {
        if (stop_.stop_requested()) throw Stopped();
        const std::string text = fields::format_seeds(list);
        replace_file(folder_.hidden() / dataset::stored::seed_file(list.frame).filename(),
                     std::as_bytes(std::span(text)));
        ++lists_;
        seeds_ += std::ssize(list.seeds);
    }

    void publish() { folder_.publish(); }
    std::int64_t lists() const { return lists_; }
    std::int64_t seeds() const { return seeds_; }

  private:
    NewFolder folder_;
    std::stop_token stop_;
    std::int64_t lists_ = 0;
    std::int64_t seeds_ = 0;
};

/// These files have flow only; objects are unknown.
void seeds_of_files(const StoredFlowSeedsJob& job, SeedFolder& folder) {
    const std::map<std::int64_t, fs::path> files = fields::files_by_frame(job.flow, {".flo"});
    if (files.empty()) {
        throw Error(ErrorCode::file_not_found,
                    fmt::format("'{}' is not an extraction and has no .flo files; name a folder of `vvr extract`, or "
                                "one with .flo files",
                                job.flow.string()));
    }
    const bool magnitude = job.seeds.order == fields::seed_orders().front();
    if (job.seeds.area->object_alone || !magnitude) {
        throw Error(ErrorCode::extraction_unsuitable,
                    fmt::format("'{}' has only flow and no objects; choose seed-area field and seed-order magnitude, "
                                "or name an extraction",
                                job.flow.string()),
                    {setting::seed_area.name, setting::seed_order.name});
    }
    for (const auto& [frame, file] : files) {
        const fields::Flow flow = fields::read_flo(file.string());
        const Plane<std::uint8_t> object(flow.u.size());
        folder.add({frame, flow.u.size(), fields::make_seeds({frame, flow, object, {}}, job.seeds)});
    }
}

void seeds_of_extraction(const StoredFlowSeedsJob& job, SeedFolder& folder) {
    dataset::StoredFields fields(std::array{job.flow.string()});
    const auto filter =
        std::ranges::find(fields.settings(), setting::filter.name, [](const auto& s) { return s.first; });
    const bool marks =
        filter != fields.settings().end() && Choice<fields::FilterRow>(filter->second)->traits.shows_object;
    if (!marks && job.seeds.area->object_alone) {
        throw Error(ErrorCode::extraction_unsuitable,
                    fmt::format("'{}' was extracted with a filter that does not mark objects, so seeds can't be "
                                "limited to them; choose seed-area field",
                                job.flow.string()),
                    {setting::seed_area.name});
    }
    Plane<std::uint16_t> age;
    const fields::FieldNeeds needs{.seeds = false, .flow = true, .colour = false, .every = fields.interval(1)};
    fields.read(needs, [&](const media::SharedFrame&, const fields::Field& field) {
        age = fields::aged(age, field.scalar);
        if (field.flow.u.empty()) return;
        folder.add({field.index, field.flow.u.size(),
                    fields::make_seeds({field.index, field.flow, field.scalar, age}, job.seeds)});
    });
}

/// Chooses seeds on a stored flow (the filter stage of §4.2, between the boxes of Fig. 3). Writes one list per frame
/// that has a flow, with its u and v. The folder must be new or empty.
/// \param stop request to stop; no folder is then left
/// \returns false if it was stopped
/// \throws Error usage for options that need data which is not stored; io
bool write_seeds(const StoredFlowSeedsJob& job, app::Observer& observer, const std::stop_token& stop) {
    fields::FieldOptions options;
    options.seeds = job.seeds;
    fields::validate(options);
    const auto held = observer.guard();  // outlives the folder, so that a signal finds it whole or removed
    SeedFolder folder(job.folder, seeds_text::output.name, stop);
    try {
        if (dataset::is_data_folder(job.flow)) {
            seeds_of_extraction(job, folder);
        } else {
            seeds_of_files(job, folder);
        }
    } catch (const Stopped&) {
        return false;
    }
    folder.publish();
    observer.info(fmt::format("'{}': {} with {}", job.folder.string(), counted(folder.lists(), "list"),
                              counted(folder.seeds(), "seed")));
    return true;
}

class Seeds final : public Command {
  public:
    void add_options(options::CommandLine& line) override {
        line.arguments(flows_, "FLOW", "a folder that `vvr extract` wrote, or one with .flo files, named by frame");
        options::AddOptions(line, options::Group::output)(seeds_text::output, job_.folder,
                                                          {.letter = 'o', .use = options::FileUse::written});
        fields::each_seed_setting(job_.seeds, options::AddOptions(line, options::Group::fields));
        line.examples({{"vvr extract clip.avi -o data", "the flow of a clip"},
                       {"vvr seeds data -o lists --seed-select first:2", "the two fastest points of each frame"},
                       {"vvr render clip.avi -o clip.png --seeds lists", "the picture with arrows at these points"}});
    }

    cli::ExitStatus run(const options::CommandLine&, const cli::Environment& environment) override {
        if (flows_.size() != 1)
            throw Error(flows_.empty() ? ErrorCode::input_missing : ErrorCode::input_unsuitable,
                        "seeds needs exactly one FLOW; name the folder of an extraction, or one with .flo files");
        if (job_.folder.empty())
            throw Error(ErrorCode::output_missing, "no output given; name the folder for the lists with -o DIR");
        job_.flow = flows_.front();
        cli::Console console(environment);
        cli::run_stoppable(environment.signals,
                           [&](const std::stop_token& stop) { return write_seeds(job_, console, stop); });
        return cli::ExitStatus::done;
    }

  private:
    StoredFlowSeedsJob job_;
    std::vector<std::string> flows_;
};

}  // namespace

std::unique_ptr<Command> make_seeds_command() {
    return std::make_unique<Seeds>();
}

}  // namespace vvr::commands
