#pragma once

#include <string>

#include "core/video/demuxer.h"
#include "core/video/frame_source.h"

namespace vvr {

/// What the container says of the video stream, with the size of its first frame as it is to be seen.
VideoInfo describe(const Demuxer& demuxer, const std::string& name, const AVFrame& first);

/// How the container wants the stream's pictures turned: the nearest quarter turn, mirrored or not.
Orientation orientation_of(const AVStream& stream);

}  // namespace vvr
