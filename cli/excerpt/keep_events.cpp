#include "cli/excerpt/keep_events.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <stop_token>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/footage/piece_names.h"
#include "core/media/container.h"
#include "core/media/packet_copy.h"

namespace vvr::app {

namespace {

/// Events that overlap in time, margins included.
struct Group {
    double first = 0;
    double last = 0;
    std::vector<PieceEvent> events;
};

std::vector<Group> group(const std::vector<tracking::Event>& events, double margin, const VideoScale& scale) {
    std::vector<PieceEvent> sorted;
    for (std::size_t k = 0; k < events.size(); ++k)
        sorted.push_back(piece_event(events[k], static_cast<std::int64_t>(k) + 1, scale));
    std::ranges::stable_sort(sorted, {}, &PieceEvent::first);
    std::vector<Group> groups;
    for (const PieceEvent& event : sorted) {
        if (groups.empty() || event.first - margin > groups.back().last + margin) {
            groups.push_back({event.first, event.last, {}});
        }
        Group& last = groups.back();
        last.last = std::max(last.last, event.last);
        last.events.push_back(event);
    }
    return groups;
}

/// The files of the footage.
std::vector<media::SegmentPlace> files_of(const Plan& plan, const Observation& seen) {
    if (!seen.info.segments.empty()) return seen.info.segments;
    return {{plan.read.input.names.front(), 0, std::numeric_limits<double>::infinity(), 0}};
}

/// What all pieces have in common.
PieceJob job_for(const Plan& plan, const Observation& seen) {
    PieceJob job;
    job.name = seen.info.name;
    job.camera = plan.read.camera;
    job.clock = plan.read.clock;
    job.places = files_of(plan, seen);
    if (plan.read.wants_clock) job.created = seen.info.created;
    job.input = plan.read.input;
    job.input.rate = seen.info.read_at;
    job.threads = plan.read.threads;
    job.warns_of_early_end = false;
    return job;
}

/// Whether an error concerns the footage only, so that other pieces may succeed.
bool is_of_the_footage(const Error& error) {
    return error.kind() == ErrorKind::usage || error.kind() == ErrorKind::not_video ||
           (error.kind() == ErrorKind::io && error.code() != ErrorCode::disk_full);
}

}  // namespace

KeptEvents keep_events(const Plan& plan, const Observation& seen, Observer& observer) {
    KeptEvents kept;
    const OutputOptions::Pieces& output = plan.output.files.pieces;
    if (!seen.events || seen.events->events.empty()) return kept;
    PieceJob job = job_for(plan, seen);
    PieceRecord record{plan.read.camera, plan.read.clock, plan.output.settings, unseen_of(plan, seen), job.places};
    const VideoScale scale(plan.read.clip.field_size, seen.info.size);
    std::map<std::string, HashedFile> footage;
    std::set<std::string> used;  // files of the pieces
    std::size_t failed = 0;
    for (Group& events : group(seen.events->events, output.margin, scale)) {
        try {
            job.span = span_around(events.first, events.last, output.margin);
            job.parts = parts_in(job.places, job.span);
            if (job.parts.empty()) throw_empty(job, "");
            const media::Input input = media::open_input(job.parts.front().file.path);
            const std::string_view extension = media::extension_to_play(input, job.input.rate);
            if (extension.empty()) {
                throw Error(ErrorCode::input_unsuitable,
                            fmt::format("no container supports all streams of '{}'", input.name));
            }
            const std::string name = footage::piece_name(events.events.front().number, extension);
            job.path = output.folder / name;
            job.place = output.place / name;
            // Before the copy: if the footage is removed during it, no piece lacks its record.
            for (const ExcerptFile& part : job.parts) {
                const std::string& file = part.file.path;
                if (!footage.contains(file)) footage.emplace(file, hashed(file, file));
            }
            const auto facts = copy_piece(job, observer, std::stop_token());
            record.pieces.push_back({name, facts.value(), std::move(events.events)});
            for (const ExcerptFile& part : job.parts) used.insert(part.file.path);
        } catch (const Error& error) {
            if (!is_of_the_footage(error)) throw;
            if (failed == 0) kept.problem = error.what();
            if (error.kind() == ErrorKind::io) kept.code = error.code();
            failed += events.events.size();
        }
    }
    if (failed > 0) {
        kept.problem = fmt::format("{} of {} could not be kept: {}", failed,
                                   counted(std::ssize(seen.events->events), "event"), kept.problem);
        observer.warn(kept.problem);
    }
    if (record.pieces.empty()) return kept;
    for (const std::string& file : used) record.footage.push_back(footage.at(file));
    write_record(output.folder, record, observer);
    kept.pieces = std::move(record.pieces);
    return kept;
}

}  // namespace vvr::app
