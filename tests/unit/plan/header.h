#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "cli/plan/make_plan.h"

namespace vvr::test {

/// What the header of a clip says of it. No file is needed for a plan.
inline app::ClipFacts header_of(std::int64_t frames = 250, double rate = 25, std::string name = "gate.avi") {
    app::ClipFacts clip{.field_size = {32, 24}, .expected_frames = frames};
    clip.info.name = std::move(name);
    clip.info.size = {320, 240};
    clip.info.rate = rate;
    clip.info.frames = frames;
    clip.info.duration = rate > 0 ? static_cast<double>(frames) / rate : 0;
    return clip;
}

}  // namespace vvr::test
