#include "core/footage/unseen.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include <fmt/format.h>

#include "core/base/json_text.h"
#include "core/base/text.h"

namespace vvr::footage {

namespace {

constexpr double little = 1;  // seconds; less is lost in any network

std::vector<std::string> faults_of(std::span<const condition::Interval> intervals, const MomentText& moment) {
    std::vector<std::string> words;
    for (const condition::ConditionRow& row : condition::condition_rows) {
        if (row.cause.empty()) continue;
        double seconds = 0;
        int count = 0;
        double begin = 0;  // of the only one
        for (const condition::Interval& interval : intervals) {
            if (interval.kind != row.kind) continue;
            seconds += interval.end - interval.begin;
            begin = interval.begin;
            ++count;
        }
        if (count == 0) continue;
        const bool is_moment = seconds < little;
        std::string text = is_moment ? std::string(row.words) : fmt::format("{} for {:.1f} s", row.words, seconds);
        if (count == 1 && moment) text += fmt::format(" {} {}", is_moment ? "at" : "from", moment(begin));
        words.push_back(std::move(text));
    }
    return words;
}

}  // namespace

std::vector<std::string> words_of(const Unseen& unseen, const MomentText& moment) {
    std::vector<std::string> words;
    if (!unseen.masked) {
        words.emplace_back("a part of the scene masked");
    } else if (const auto percent = std::llround(100 * *unseen.masked); percent > 0) {
        words.push_back(fmt::format("{} % of the scene masked", percent));
    }
    double lost = 0;
    for (const media::FrameGap& gap : unseen.gaps) lost += gap.numbered ? 0 : gap.end - gap.begin;
    if (lost >= little) words.push_back(fmt::format("no frames for {:.1f} s", lost));
    std::ranges::move(faults_of(unseen.intervals, moment), std::back_inserter(words));
    if (unseen.damaged > 0) words.push_back(counted(unseen.damaged, "damaged packet"));
    if (unseen.dropped > 0) words.push_back(counted(unseen.dropped, "frame") + " dropped");
    return words;
}

Json json_of(const Unseen& unseen, const std::function<Json(double)>& moment) {
    const auto area = [](const Unseen::Area& of) {
        return Json{{"option", of.option}, {"value", of.value}, {"sha256", or_null(of.sha256)}};
    };
    const auto gap = [&](const media::FrameGap& of) {
        return Json{{"begin", moment(of.begin)},
                    {"end", moment(of.end)},
                    {"seconds", rounded(of.end - of.begin)},
                    {"frames", of.frames}};
    };
    const auto damage = [&](const media::Damage& of) {
        return Json{{"begin", moment(of.begin)}, {"end", moment(of.end)}, {"packets", of.packets}};
    };
    const auto interval = [&](const condition::Interval& of) {
        return Json{{"kind", row_of(of.kind).name}, {"begin", moment(of.begin)}, {"end", moment(of.end)}};
    };
    return {{"masked", unseen.masked ? Json(rounded(*unseen.masked)) : Json()},
            {"areas", list_of(unseen.areas, area)},
            {"gaps", list_of(unseen.gaps, gap)},
            {"damage", list_of(unseen.damage, damage)},
            {"intervals", list_of(unseen.intervals, interval)},
            {"damaged", unseen.damaged},
            {"dropped", unseen.dropped}};
}

std::vector<std::string> faults_from(const Json& json) {
    std::vector<condition::Interval> intervals;
    for (const Json& interval : json.at("intervals")) {
        const auto row = std::ranges::find(condition::condition_rows, interval.at("kind").get<std::string>(),
                                           &condition::ConditionRow::name);
        if (row == condition::condition_rows.end()) continue;
        intervals.push_back({interval.at("begin").at("seconds").get<double>(),
                             interval.at("end").at("seconds").get<double>(), row->kind});
    }
    return faults_of(intervals, {});
}

Unseen unseen_areas_from(const Json& json) {
    Unseen unseen;
    if (!json.is_object()) return unseen;
    unseen.masked = json.at("masked").is_number() ? std::optional(json["masked"].get<double>()) : std::nullopt;
    for (const Json& area : json.at("areas")) {
        const Json& digest = area.at("sha256");
        unseen.areas.push_back({area.at("option"), area.at("value"), digest.is_string() ? digest : Json("")});
    }
    return unseen;
}

}  // namespace vvr::footage
