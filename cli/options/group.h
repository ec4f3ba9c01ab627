#pragma once

namespace vvr {

/// Groups of options, as `--help` shows them.
enum class Group { input, fields, bricks, view, look, output, archive, workers, comparison, run };

/// The heading of a group.
constexpr const char* title_of(Group group) {
    constexpr const char* titles[] = {"Input",  "Fields",  "Bricks",  "Layout and view", "Look",
                                      "Output", "Archive", "Workers", "Comparison",      "Run"};
    return titles[static_cast<int>(group)];
}

}  // namespace vvr
