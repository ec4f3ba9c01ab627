#pragma once

#include <cstdint>

#include "core/plane.h"
#include "gl/objects.h"

namespace vvr {

/// A texture that is smooth however small it is seen, of bytes as one channel or of a picture's colours. Its levels
/// come with it: for glGenerateMipmap Mesa's software rasteriser compiles shaders of its own each time anew, a quarter
/// of a second a run.
///
/// \throws Error limit when there is no memory for it, backend for anything else, as check_gl does
GlTexture smooth_texture(const GladGLContext& gl, const Plane<std::uint8_t>& picture);
GlTexture smooth_texture(const GladGLContext& gl, const Plane<Bgr>& picture);

/// The same along a line that repeats, a row of bytes.
GlTexture smooth_repeating_texture(const GladGLContext& gl, const Plane<std::uint8_t>& row);

}  // namespace vvr
