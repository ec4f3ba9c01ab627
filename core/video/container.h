#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/video/input.h"

namespace vvr::video {

/// A container format that clips can be written in.
struct ContainerRow {
    std::string_view name;  ///< file extension, with its dot
    const char* muxer;      ///< libav's name of the muxer
};

std::span<const ContainerRow> containers();

/// The container for a file extension.
/// \throws Error usage for an unknown extension
const ContainerRow& container_of(const std::filesystem::path& path);

/// The streams of a clip that are copied: video, audio and subtitles.
std::vector<const AVStream*> media_of(const AVFormatContext& clip);

/// \throws Error usage if the container can't hold a stream of the clip; the message names containers that can
void check_container(const ContainerRow& container, const AVFormatContext& clip, const std::filesystem::path& path);

/// The extension of a container that can hold the clip's streams: the clip's own, or else the first in the table that
/// fits. Empty if none fits.
std::string_view extension_for(const Input& clip, double rate);

}  // namespace vvr::video
