#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/image/codec.h"
#include "core/image/picture.h"

namespace vvr::image {

/// The extensions of picture files that can be written, with their dots.
std::vector<std::string> picture_file_extensions();

/// Checks that the extension of `path` is a known format.
/// \throws Error usage if it isn't
void check_picture_extension(const std::filesystem::path& path);

/// Checks that `write_picture` can write to `path`, before any long work.
/// \throws Error usage for an unknown extension, io if the folder doesn't exist or isn't writable
void check_picture_path(const std::filesystem::path& path);

/// Whether the format of `path` can hold pixel data.
bool holds_pixel_data(const std::filesystem::path& path);

/// Encodes a picture file in the format of `path`'s extension, with its settings and, if the format can hold it, its
/// pixel data in the channels `Z`, `time`, `frame` and `object`. The output is deterministic and has no date.
/// \param picture move it here: it is freed before encoding, to save memory
/// \param jpeg_quality 1..100
/// \throws Error usage for an unknown extension, io for a picture too large for the format
std::vector<std::byte> encode_picture(const std::filesystem::path& path, Picture picture, const Metadata& metadata = {},
                                      int jpeg_quality = 95);

/// Encodes a frame in an 8-bit format.
std::vector<std::byte> encode_picture(const std::filesystem::path& path, const Plane<Bgr>& picture,
                                      int jpeg_quality = 95);

/// Encodes a picture and replaces `path` atomically.
/// \throws Error usage or io, as `check_picture_path`, and io if the disk is full
void write_picture(const std::filesystem::path& path, Picture picture, const Metadata& metadata = {});

/// The settings that `write_picture` stored in a file.
Metadata settings_of(const Samples& file);

}  // namespace vvr::image
