#include "cli/excerpt/piece_record.h"

#include <cstdint>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

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

using Json = nlohmann::ordered_json;

/// Increase it when readers of older records would misread a new one.
constexpr int format_version = 1;

Json json_of(const std::optional<PixelBox>& box) {
    if (!box) return {};
    return {{"x", box->left}, {"y", box->top}, {"width", box->width()}, {"height", box->height()}};
}

Json json_of(const PieceEvent& event, const MomentPlaces& places) {
    return {{"number", event.number},
            {"kind", event.kind},
            {"class", event.what.empty() ? Json() : Json(event.what)},
            {"first", places(event.first)},
            {"last", places(event.last)},
            {"box", json_of(event.box)}};
}

Json json_of(const PieceRecord& record, const WrittenPiece& piece, const MomentPlaces& places) {
    const PieceFacts& facts = piece.facts;
    Json parts = Json::array();
    std::int64_t present = 0;
    for (const PieceFacts::Part& part : facts.parts) {
        present += part.frames;
        parts.push_back({{"file", part.file},
                         {"first_frame", part.first_frame},
                         {"last_frame", part.last_frame},
                         {"frames", part.frames}});
    }
    std::int64_t expected = present;
    for (const media::FrameGap& gap : facts.gaps) expected += gap.frames;
    footage::Unseen unseen = record.unseen;
    unseen.gaps = facts.gaps;
    unseen.damage = facts.damage;
    unseen.damaged = 0;
    for (const media::Damage& damage : facts.damage) unseen.damaged += damage.packets;
    Json json{{"first", places(facts.begin)},
              {"last", places(facts.end)},
              {"frames", {{"present", present}, {"expected", expected}}},
              {"parts", parts},
              {"unseen", json_of(unseen, places)},
              {"events", Json()}};
    if (!piece.events) return json;
    json["events"] = Json::array();
    for (const PieceEvent& event : *piece.events) json["events"].push_back(json_of(event, places));
    return json;
}

Json json_of(const WallClock& clock) {
    if (!clock) return {};
    const ClockSourceRow& source = row_of(clock->source);
    return {
        {"source", source.name}, {"words", source.words}, {"zone", clock->zone.empty() ? Json() : Json(clock->zone)}};
}

Json json_of(const HashedFile& file) {
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
        Json json = json_of(file);
        json.update(more);
        return json;
    };
    Json json{{"evidence", format_version},
              {"vvr", version()},
              {"camera", record.camera.empty() ? Json() : Json(record.camera)},
              {"clock", json_of(record.clock)},
              {"footage", Json::array()},
              {"pieces", Json::array()},
              {"stills", Json::array()},
              {"settings", Json::object()}};
    for (const HashedFile& file : record.footage) json["footage"].push_back(json_of(file));
    const MomentPlaces places{record.places, record.clock};
    for (const WrittenPiece& piece : record.pieces)
        json["pieces"].push_back(add(piece.file, json_of(record, piece, places)));
    if (const auto& still = record.still) {
        Json at = places(still->seconds);
        at["frame"] = still->frame;
        json["stills"].push_back(add(still->file, {{"at", at}, {"box", json_of(still->box)}}));
        if (still->box) json["stills"].push_back(add(still->marked, {{"marks", still->file}}));
    }
    for (const auto& [name, value] : record.settings) json["settings"][name] = value;
    const std::string text = json_text(json, 2) + "\n";
    write(folder / footage::record_name, text, observer);
    sums += fmt::format("{}  {}\n", hex_sha256(text), footage::record_name);
    write(folder / footage::sums_name, sums, observer);
}

}  // namespace vvr::app
