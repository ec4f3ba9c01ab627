#pragma once

#include "core/image/picture.h"

namespace vvr::app {

/// Settings with the values that were used: where a filter, a solver or a theme decided, the value that it has, as one
/// would give it on the command line. What nobody gave and nothing decided is left out.
image::Metadata used_settings(const image::Metadata& settings);

}  // namespace vvr::app
