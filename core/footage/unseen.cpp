#include "core/footage/unseen.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/text.h"

namespace vvr::footage {

using Json = nlohmann::ordered_json;

std::vector<std::string> words_of(const Unseen& unseen) {
    constexpr double little = 1;  // seconds; less is lost in any network
    std::vector<std::string> words;
    if (!unseen.masked) {
        words.emplace_back("a part of the scene masked");
    } else if (const auto percent = std::llround(100 * *unseen.masked); percent > 0) {
        words.push_back(fmt::format("{} % of the scene masked", percent));
    }
    double lost = 0;
    for (const media::FrameGap& gap : unseen.gaps) lost += gap.numbered ? 0 : gap.end - gap.begin;
    if (lost >= little) words.push_back(fmt::format("no frames for {:.1f} s", lost));
    if (unseen.damaged > 0) words.push_back(counted(unseen.damaged, "damaged packet"));
    if (unseen.dropped > 0) words.push_back(counted(unseen.dropped, "frame") + " dropped");
    return words;
}

Json json_of(const Unseen& unseen, const std::function<Json(double)>& moment) {
    Json json{{"masked", unseen.masked ? Json(rounded(*unseen.masked)) : Json()},
              {"areas", Json::array()},
              {"gaps", Json::array()},
              {"damage", Json::array()},
              {"damaged", unseen.damaged},
              {"dropped", unseen.dropped}};
    for (const Unseen::Area& area : unseen.areas)
        json["areas"].push_back({{"option", area.option},
                                 {"value", area.value},
                                 {"sha256", area.sha256.empty() ? Json() : Json(area.sha256)}});
    for (const media::FrameGap& gap : unseen.gaps) {
        json["gaps"].push_back({{"begin", moment(gap.begin)},
                                {"end", moment(gap.end)},
                                {"seconds", rounded(gap.end - gap.begin)},
                                {"frames", gap.frames}});
    }
    for (const media::Damage& damage : unseen.damage)
        json["damage"].push_back(
            {{"begin", moment(damage.begin)}, {"end", moment(damage.end)}, {"packets", damage.packets}});
    return json;
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
