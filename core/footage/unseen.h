#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/condition/condition.h"
#include "core/media/frame_gaps.h"

namespace vvr::footage {

/// What nobody looked at in a clip or a part of it: for the report, the evidence, the page and the picture.
struct Unseen {
    /// An area that was left out on request.
    struct Area {
        std::string option;  ///< "roi" or "mask"
        std::string value;   ///< polygons, or the file's name without its folders
        std::string sha256;  ///< of the file's bytes, or of the polygons; empty = unknown
    };
    std::vector<Area> areas{};
    std::optional<double> masked = 0;              ///< share of the scene outside the region; none = unknown
    std::vector<media::FrameGap> gaps{};           ///< in order, without those that nobody asked for
    std::vector<media::Damage> damage{};           ///< in order
    std::vector<condition::Interval> intervals{};  ///< what the recording itself did, in order
    std::int64_t damaged = 0;                      ///< packets in all; of an extraction, nobody knows when
    std::int64_t dropped = 0;                      ///< frames of a live stream that came too fast
};

/// A time in seconds as a text.
using MomentText = std::function<std::string(double)>;

/// In a few words each: "50 % of the scene masked", "no new pictures for 20.0 s from 0:30". Gaps that the ruler shows
/// are left out.
/// \param moment empty = no times
std::vector<std::string> words_of(const Unseen& unseen, const MomentText& moment = {});

/// \param moment a time in seconds as JSON
nlohmann::ordered_json json_of(const Unseen& unseen, const std::function<nlohmann::ordered_json(double)>& moment);

/// What a report says of the recording's faults, in the words of `words_of`.
/// \throws nlohmann::ordered_json::exception
std::vector<std::string> faults_from(const nlohmann::ordered_json& json);

/// What a report says of the areas that were left out.
/// \throws nlohmann::ordered_json::exception
Unseen unseen_areas_from(const nlohmann::ordered_json& json);

}  // namespace vvr::footage
