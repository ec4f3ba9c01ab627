#pragma once

#include "core/image/picture.h"

namespace vvr::app {

/// The settings with the values that were used. Where a filter, a solver or a theme determines a value, it is filled in
/// as one would type it. A setting that has no value is left out.
image::Metadata used_settings(const image::Metadata& settings);

}  // namespace vvr::app
