#pragma once

#include <string>
#include <vector>

#include "cli/render/observer.h"

namespace vvr {

/// Warns of what was wrong with an input: all warnings, and some of the files' problems.
void tell_problems(const std::vector<std::string>& warnings, const std::vector<std::string>& problems,
                   Observer& observer);

}  // namespace vvr
