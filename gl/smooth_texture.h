#pragma once

#include <cstdint>

#include "core/base/plane.h"
#include "gl/objects.h"

namespace vvr::gl {

/// A texture with mip levels, of bytes as one channel or of a picture's colours. The levels are computed on the CPU:
/// for glGenerateMipmap Mesa's software rasteriser compiles shaders of its own, which takes a quarter of a second in
/// each run.
///
/// \throws Error limit when there is no memory for it, backend for anything else, as check_gl does
GlTexture mipmapped_texture(const GladGLContext& gl, const Plane<std::uint8_t>& picture);
GlTexture mipmapped_texture(const GladGLContext& gl, const Plane<Bgr>& picture);

/// A one-dimensional one that repeats, of a row of bytes.
GlTexture mipmapped_repeating_texture(const GladGLContext& gl, const Plane<std::uint8_t>& row);

}  // namespace vvr::gl
