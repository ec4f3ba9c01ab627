#include "cli/excerpt/piece.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/atomic_file.h"
#include "core/base/digest.h"
#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/footage/open_source.h"
#include "core/footage/piece_names.h"
#include "core/footage/recorder_names.h"
#include "core/footage/segments.h"
#include "core/media/container.h"
#include "core/media/frame_source.h"
#include "core/media/packet_copy.h"
#include "core/media/scaler.h"

namespace vvr::app {

namespace {

namespace fs = std::filesystem;

/// Thrown by the writing function, so that the partial file is removed.
struct Stopped {};

/// "2026-11-22T02:12:10+01:00 to 2026-11-22T02:13:40+01:00"; empty = unknown.
std::string time_of_day(const PieceJob& job, double begin, double end) {
    return job.clock ? fmt::format("{} to {}", job.clock->iso(begin), job.clock->iso(end)) : "";
}

/// The time of a second of the recording, in seconds since 1970 (UTC); none = unknown.
std::optional<double> utc_at(const PieceJob& job, double seconds) {
    if (job.clock) return static_cast<double>(footage::utc_of({job.clock->begin, job.clock->utc_offset})) + seconds;
    return job.created ? std::optional(static_cast<double>(*job.created) + seconds) : std::nullopt;
}

std::string files_of(const PieceJob& job) {
    constexpr std::size_t most = 20;
    std::vector<std::string> names;
    for (const ExcerptFile& part : job.parts) names.push_back(shown_text(fs::path(part.file.path).filename().string()));
    const std::size_t more = names.size() - std::min(names.size(), most);
    names.resize(names.size() - more);
    return fmt::format("{}{}", fmt::join(names, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

/// The metadata of the piece: camera, day, time, and source files.
/// \param begin time of the first frame, in seconds of the recording
/// \param end time of the last frame
media::Tags tags_of(const PieceJob& job, double begin, double end) {
    media::Tags tags;
    if (!job.camera.empty()) tags.emplace_back("title", shown_text(job.camera));
    std::string comment = shown_text(job.camera);
    const std::string day = time_of_day(job, begin, end);
    for (const std::string& words : {day, fmt::format("cut by vvr from {}", files_of(job))}) {
        if (!words.empty()) comment += (comment.empty() ? "" : "; ") + words;
    }
    tags.emplace_back("comment", comment);
    const std::optional<double> made = utc_at(job, begin);
    if (!made) return tags;
    const auto milliseconds = static_cast<std::int64_t>(std::floor(*made * 1000 + 1e-3));
    const std::int64_t rest = ((milliseconds % 1000) + 1000) % 1000;
    const std::string time =
        fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime((milliseconds - rest) / 1000), rest);
    tags.emplace_back("creation_time", time);
    if (media::container_of(job.path).name == ".avi") tags.emplace_back("date", time);  // AVI lacks the other tag
    return tags;
}

/// ", which is 2026-11-22T02:12:10+01:00 to ..."
std::string day_in_words(const PieceJob& job, double begin, double end) {
    const std::string day = time_of_day(job, begin, end);
    return day.empty() ? day : fmt::format(", which is {}", day);
}

/// The interval in seconds of its files.
std::string files_text(const PieceJob& job, double begin, double end) {
    const auto [file, offset] = footage::file_at(job.places, begin);
    const auto [last_file, last_offset] = footage::file_at(job.places, end);
    const std::string from = file == last_file ? "" : fmt::format(" of '{}'", file->path);
    return fmt::format("{:.3f} s{} to {:.3f} s of '{}'", offset, from, last_offset, last_file->path);
}

/// What the packets tell of a piece.
PieceFacts facts_of(const std::vector<media::CopyPart>& parts) {
    const media::CopyPart& last = parts.back();
    PieceFacts facts{parts.front().begin + parts.front().piece.begin, last.begin + last.piece.end,
                     last.begin + last.piece.until};
    media::FrameGaps find_gap(1 / (last.piece.until - last.piece.end));
    double before = facts.begin;
    for (const media::CopyPart& part : parts) {
        const auto& frames = part.piece.frames;
        facts.parts.push_back({part.input.name, frames.front().number, frames.back().number, std::ssize(frames)});
        for (const media::PacketRange::Frame& frame : frames) {
            const double time = part.begin + frame.time;
            if (const auto gap = find_gap(time)) facts.gaps.push_back(*gap);
            if (frame.damaged) add_damage(facts.damage, {before, time, 1});
            before = time;
        }
    }
    return facts;
}

// ---- A copy

std::vector<media::CopyPart> parts_to_copy(const PieceJob& job) {
    std::vector<media::CopyPart> copied;
    std::optional<double> over;
    for (const ExcerptFile& part : job.parts) {
        if (part.overlaps) {
            throw Error(ErrorCode::input_unsuitable,
                        fmt::format("'{}' overlaps the file before it, so a copy would repeat some frames; cut each "
                                    "file by itself",
                                    part.file.path));
        }
        media::Input input = media::open_track(part.file.path, job.input.track);
        const media::PacketRange piece = media::find_packets(input, job.input.rate, part.span);
        if (piece.frames.empty() && piece.over) over = part.file.begin + *piece.over;
        if (!piece.frames.empty()) copied.push_back({std::move(input), piece, part.file.begin});
    }
    if (copied.empty()) {
        throw_empty(job, over ? fmt::format("; the last frame before that is at {}", asked_text(job, *over)) : "");
    }
    return copied;
}

}  // namespace

std::string asked_text(const PieceJob& job, double seconds) {
    return job.by_clock ? job.clock->iso(seconds) : fmt::format("{:.3f} s", seconds);
}

std::string interval_text(const PieceJob& job, double begin, double end) {
    return job.by_clock ? time_of_day(job, begin, end) : files_text(job, begin, end);
}

void throw_empty(const PieceJob& job, const std::string& rest) {
    std::string span = media::text_of(job.span);
    if (job.by_clock) {
        const std::string end = job.span.end ? asked_text(job, *job.span.end) : "its end";
        span = fmt::format("from {} to {}", asked_text(job, job.span.start), end);
    }
    throw Error(ErrorCode::span_empty,
                fmt::format("'{}' has no frame {}{}; choose another part", job.name, span, rest));
}

std::optional<PieceFacts> copy_piece(const PieceJob& job, Observer& observer, const std::stop_token& stop) {
    const std::vector<media::CopyPart> parts = parts_to_copy(job);
    const media::CopyPart& first = parts.front();
    PieceFacts facts = facts_of(parts);
    const media::Tags tags = tags_of(job, facts.begin, facts.end);
    media::CopyResult copied;
    try {
        const auto held = observer.guard();
        const auto check_stop = [&] {
            if (stop.stop_requested()) throw Stopped();
        };
        replace_file(job.path, [&](const WriteAt& write_at) {
            copied = media::copy_pieces(parts, job.input.rate, job.path, tags, write_at, check_stop);
        });
    } catch (const Stopped&) {
        return std::nullopt;
    }
    if (job.warns_of_early_end && parts.back().piece.ends_early) {
        observer.warn(fmt::format("'{}' ends at {}, earlier than the requested end of the piece", job.name,
                                  asked_text(job, facts.end)));
    }
    std::int64_t damaged = 0;
    for (const media::Damage& damage : facts.damage) damaged += damage.packets;
    if (damaged > 0) {
        observer.warn(
            fmt::format("'{}': {} copied unchanged into the piece", job.name, counted(damaged, "damaged packet")));
    }
    if (!copied.left_out.empty()) {
        observer.info(fmt::format("'{}': left out streams that are neither video, audio nor subtitles: {}",
                                  job.shown().string(), fmt::join(copied.left_out, ", ")));
    }
    const double before = first.piece.wanted - first.piece.begin;
    const std::string lead = before < 0.0005 ? "" : fmt::format(" {:.3f} s before the piece", before);
    observer.info(fmt::format("'{}': {} copied, {}{}; it begins at a key frame{}", job.shown().string(),
                              counted(copied.packets, "frame"), files_text(job, facts.begin, facts.end),
                              day_in_words(job, facts.begin, facts.end), lead));
    return facts;
}

FullFrame frame_of(const PieceJob& job, double seconds) {
    media::SourceOptions options;
    options.field_size = {-1, -1};
    options.colour = true;
    options.threads = job.threads;
    options.rate = job.input.rate;
    const auto [file, offset] = footage::file_at(job.places, seconds);
    double from = offset;
    for (const auto& place : std::span(job.places).subspan(static_cast<std::size_t>(file - job.places.data()))) {
        const auto source = footage::open_source(place.path, options);
        source->seek(std::max(0.0, from - 1));
        auto frame = source->next();
        while (frame && frame->pts < from - media::time_tolerance) frame = source->next();
        if (frame) {
            media::Scaler scale(source->field_size(), true);
            return {place.begin + frame->pts, frame->index, scale(*frame).colour};
        }
        from = 0;
    }
    throw_empty(job, "");
}

namespace {

namespace fs = std::filesystem;

/// Increase it when readers of older records would misread a new one.
constexpr int format_version = 1;

Json json_of(const std::optional<PixelBox>& box) {
    return box ? json_of_box(*box) : Json();
}

Json json_of(const PieceEvent& event, const MomentPlaces& places) {
    return {{"number", event.number},       {"kind", event.kind},         {"class", or_null(event.what)},
            {"first", places(event.first)}, {"last", places(event.last)}, {"box", json_of(event.box)}};
}

Json json_of(const PieceRecord& record, const WrittenPiece& piece, const MomentPlaces& places) {
    const PieceFacts& facts = piece.facts;
    std::int64_t present = 0;
    for (const PieceFacts::Part& part : facts.parts) present += part.frames;
    const auto json_of_part = [](const PieceFacts::Part& part) {
        return Json{{"file", part.file},
                    {"first_frame", part.first_frame},
                    {"last_frame", part.last_frame},
                    {"frames", part.frames}};
    };
    std::int64_t expected = present;
    for (const media::FrameGap& gap : facts.gaps) expected += gap.frames;
    footage::Unseen unseen = record.unseen;
    std::erase_if(unseen.intervals, [&](const condition::Interval& interval) {
        return interval.end <= facts.begin || interval.begin >= facts.end;
    });
    for (condition::Interval& interval : unseen.intervals) {
        interval.begin = std::max(interval.begin, facts.begin);
        interval.end = std::min(interval.end, facts.end);
    }
    unseen.gaps = facts.gaps;
    unseen.damage = facts.damage;
    unseen.damaged = 0;
    for (const media::Damage& damage : facts.damage) unseen.damaged += damage.packets;
    Json json{{"first", places(facts.begin)},
              {"last", places(facts.end)},
              {"frames", {{"present", present}, {"expected", expected}}},
              {"parts", list_of(facts.parts, json_of_part)},
              {"unseen", json_of(unseen, places)},
              {"events", Json()}};
    if (piece.events)
        json["events"] = list_of(*piece.events, [&](const PieceEvent& event) { return json_of(event, places); });
    return json;
}

Json json_of(const WallClock& clock) {
    if (!clock) return {};
    const ClockSourceRow& source = row_of(clock->source);
    return {{"source", source.name}, {"words", source.words}, {"zone", or_null(clock->zone)}};
}

Json json_of_file(const HashedFile& file) {
    return {{"file", file.name}, {"bytes", file.bytes}, {"sha256", file.sha256}};
}

void write(const fs::path& path, const std::string& text, Observer& observer) {
    const auto held = observer.guard();
    replace_file(path, std::as_bytes(std::span(text)));
}

}  // namespace

HashedFile hashed(const fs::path& path, const std::string& name) {
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(path, error);
    if (error) throw system_error(error.value(), fmt::format("cannot read '{}'", path.string()));
    return {name, bytes, hex_sha256_of_file(path)};
}

void write_record(const fs::path& folder, const PieceRecord& record, Observer& observer) {
    std::string sums;
    const auto add = [&](const std::string& name, Json more) {
        const HashedFile file = hashed(folder / name, name);
        sums += fmt::format("{}  {}\n", file.sha256, name);
        Json json = json_of_file(file);
        json.update(more);
        return json;
    };
    Json json{{"evidence", format_version},
              {"vvr", version()},
              {"camera", or_null(record.camera)},
              {"clock", json_of(record.clock)},
              {"footage", list_of(record.footage, json_of_file)},
              {"pieces", Json::array()},
              {"stills", Json::array()},
              {"settings", object_of(record.settings)}};
    const MomentPlaces places{record.places, record.clock};
    for (const WrittenPiece& piece : record.pieces)
        json["pieces"].push_back(add(piece.file, json_of(record, piece, places)));
    if (const auto& still = record.still) {
        Json at = places(still->seconds);
        at["frame"] = still->frame;
        json["stills"].push_back(add(still->file, {{"at", at}, {"box", json_of(still->box)}}));
        if (still->box) json["stills"].push_back(add(still->marked, {{"marks", still->file}}));
    }
    const std::string text = json_text(json, 2) + "\n";
    write(folder / footage::record_name, text, observer);
    sums += fmt::format("{}  {}\n", hex_sha256(text), footage::record_name);
    write(folder / footage::sums_name, sums, observer);
}

}  // namespace vvr::app
