#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/image/codec.h"
#include "core/image/picture.h"

namespace vvr::image {

/// Endings of the picture files that can be written, with their dots.
std::vector<std::string> picture_file_extensions();

/// Says whether there is a format for the ending of `path`.
/// \throws Error usage
void check_picture_extension(const std::filesystem::path& path);

/// Says before any long work whether `write_picture` could write to `path`.
/// \throws Error usage for an ending that is not in the table of formats, io for a folder that isn't there or that
///         can't be written to
void check_picture_path(const std::filesystem::path& path);

/// Whether the format of `path` holds a picture's pixel data.
bool holds_pixel_data(const std::filesystem::path& path);

/// The bytes of a picture file in the format that the ending of `path` names, with its settings, and its pixel data
/// where the format holds it: channels `Z`, `time` and `frame`. Same picture and settings, same bytes: no date goes
/// into the file.
/// \param jpeg_quality 1..100
/// \throws Error usage for an ending that is not in the table of formats, io for a picture too large for the format
/// The picture is taken by value: one that is moved here is freed before it is encoded.
std::vector<std::byte> encode_picture(const std::filesystem::path& path, Picture picture, const Metadata& metadata = {},
                                      int jpeg_quality = 95);

/// The same for a frame, in a format of 8-bit values.
std::vector<std::byte> encode_picture(const std::filesystem::path& path, const Plane<Bgr>& picture,
                                      int jpeg_quality = 95);

/// Writes what `encode_picture` makes. The target is replaced as a whole or not touched at all.
/// \throws Error usage or io, as `check_picture_path` does, and io when the disk is full
void write_picture(const std::filesystem::path& path, Picture picture, const Metadata& metadata = {});

/// The settings that `write_picture` left in a file.
Metadata settings_of(const Samples& file);

}  // namespace vvr::image
