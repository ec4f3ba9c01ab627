#pragma once

#include <string>

#include "core/video/av.h"

// Files that name other files (HLS and the like) are read from servers alone. On this machine a folder, a pattern or a
// list of vvr's own says the same, and none of them leads anywhere else.
namespace vvr::video {

/// Whether a name is that of a playlist.
bool is_playlist_name(const std::string& name);

/// Whether files of a format name other files.
bool is_playlist_format(const AVInputFormat& format);

/// libav's names of all containers but those that name other files, as its `format_whitelist` wants them.
std::string formats_of_clips();

}  // namespace vvr::video
