#pragma once

#include <vvr/image.h>

#include "core/image/picture.h"

namespace vvr {

/// A drawn picture as those who use the library see it.
Image image_of(const image::Picture& picture, const image::Metadata& settings);

}  // namespace vvr
