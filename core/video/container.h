#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/video/input.h"

namespace vvr::video {

/// One row of the table of containers that clips are written in.
struct ContainerRow {
    std::string_view name;  ///< the file's ending
    const char* muxer;      ///< libav's name
};

std::span<const ContainerRow> containers();

/// The container of a file's ending.
/// \throws Error usage where there is none
const ContainerRow& container_of(const std::filesystem::path& path);

/// The streams of a clip that are copied: picture, sound and text.
std::vector<const AVStream*> media_of(const AVFormatContext& clip);

/// \throws Error usage where the container can't hold a stream, which names some that can
void check_container(const ContainerRow& container, const AVFormatContext& clip, const std::filesystem::path& path);

/// The ending of a file that can hold what a clip has: the clip's own, else the first in the table; empty where none
/// can.
std::string_view extension_for(const Input& clip, double rate);

}  // namespace vvr::video
