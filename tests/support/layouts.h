#pragma once

#include <string>
#include <vector>

#include "core/space/layout.h"

namespace vvr::test {

/// The names of all layouts.
inline std::vector<std::string> layout_names() {
    std::vector<std::string> names;
    for (const space::LayoutRow& row : space::layouts()) names.push_back(row.name);
    return names;
}

}  // namespace vvr::test
