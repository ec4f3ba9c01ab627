#include "cli/excerpt/piece_record.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/base/atomic_file.h"
#include "core/base/digest.h"
#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/footage/piece_names.h"

namespace vvr::app {

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
