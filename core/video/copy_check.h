#pragma once

#include <filesystem>
#include <span>

#include "core/video/packet_copy.h"

namespace vvr::video {

/// Decodes the beginning of each part of a copy.
/// \param copy what copy_pieces wrote
/// \param path by which messages name it
/// \throws Error not_video where there are other pictures than in the file that it was copied from, or other packets
void check_copy(const std::filesystem::path& copy, std::span<const CopyPart> parts, const CopyResult& copied, double rate,
                const std::filesystem::path& path);

}  // namespace vvr::video
