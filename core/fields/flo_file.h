#pragma once

#include <string>
#include <string_view>

#include "core/fields/field.h"

namespace vvr::fields {

/// A flow in the format of Middlebury's benchmark (`.flo`, in docs/formats.md), which OpenCV's readOpticalFlow reads.
std::string encode_flo(const Flow& flow);

/// Values beyond 1e9 mean "unknown" there, and are kept.
/// \param name of the file, for the error text
/// \throws Error io for another magic number, sizes that can't be, a file too short or too long, a NaN
Flow decode_flo(std::string_view bytes, const std::string& name);

/// \throws Error io as above, or when the file can't be read
Flow read_flo(const std::string& path);

}  // namespace vvr::fields
