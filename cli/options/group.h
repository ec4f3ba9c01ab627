#pragma once

#include <array>

namespace vvr::options {

/// Groups of options, as `--help` shows them.
enum class Group { output, comparison, archive, workers, input, fields, bricks, view, look, run };

/// All of them, in the order of the help.
inline constexpr std::array all_groups{Group::output, Group::comparison, Group::archive, Group::workers, Group::input,
                                       Group::fields, Group::bricks,     Group::view,    Group::look,    Group::run};

/// The heading of a group.
constexpr const char* title_of(Group group) {
    constexpr const char* titles[] = {"Output", "Comparison", "Archive",         "Workers", "Input",
                                      "Fields", "Bricks",     "Layout and view", "Look",    "Run"};
    return titles[static_cast<int>(group)];
}

}  // namespace vvr::options
