#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/image/picture.h"

namespace vvr {

/// Endings of the picture files that can be written, with their dots.
std::vector<std::string> picture_endings();

/// Says whether there is a format for the ending of `path`.
/// \throws Error usage
void check_picture_ending(const std::filesystem::path& path);

/// Says before any long work whether `write_picture` could write to `path`.
/// \throws Error usage for an ending that is not in the table of formats, io for a folder that isn't there or that
///         can't be written to
void check_picture_path(const std::filesystem::path& path);

/// Whether the format of `path` holds a picture's layers.
bool holds_layers(const std::filesystem::path& path);

/// The bytes of a picture file, of the format that the ending of `path` names.
/// \param jpeg_quality 1..100
/// \throws Error usage for an ending that is not in the table of formats
std::vector<unsigned char> encode_picture(const std::filesystem::path& path, const Picture& picture,
                                          const Metadata& metadata = {}, int jpeg_quality = 95);

/// Writes `picture` with its settings, and its layers where the format holds them: channels `Z`, `time` and `frame`.
/// Same picture and settings, same bytes: no date goes into the file. The target
/// is replaced as a whole or not touched at all. Linear values are encoded as sRGB in the formats of integers.
/// \throws Error usage or io, as `check_picture_path` does, and io when the disk is full
void write_picture(const std::filesystem::path& path, const Picture& picture, const Metadata& metadata = {});

/// Reads any picture file that OpenImageIO knows, with those layers that it has.
/// \throws Error io
Picture read_picture(const std::filesystem::path& path);

/// The settings that `write_picture` left in a file.
/// \throws Error io
Metadata read_metadata(const std::filesystem::path& path);

}  // namespace vvr
