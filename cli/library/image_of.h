#pragma once

#include <vvr/image.h>

#include "core/image/picture.h"

namespace vvr {

/// A drawn picture in the library's public type.
Image image_of(const image::Picture& picture, const image::Metadata& settings);

}  // namespace vvr
