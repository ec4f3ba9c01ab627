#pragma once

#include <string>
#include <string_view>

#include "core/fields/field.h"

namespace vvr::fields {

/// A flow in the format of the Middlebury benchmark (`.flo`, see docs/formats.md), which OpenCV's readOpticalFlow
/// reads.
std::string encode_flo(const Flow& flow);

/// Reads a flow from a file's bytes. Values above 1e9 mean "unknown" in the format, and are kept.
/// \param name of the file, for error messages
/// \throws Error io for a wrong magic number, invalid sizes, a file too short or too long, or a NaN
Flow decode_flo(std::string_view bytes, const std::string& name);

/// \throws Error io as above, or if the file can't be read
Flow read_flo(const std::string& path);

}  // namespace vvr::fields
