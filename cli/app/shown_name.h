#pragma once

#include <string>

#include "core/video/frame_source.h"

namespace vvr::app {

/// What a picture and a page call their clip: an input's name without its folders, which are nobody's business. Of an
/// address neither who may see it is told, nor by what word.
std::string shown_name(const std::string& input);

/// What stands over a picture and its page: what was asked for, else the name of the clip, which data files remember.
std::string title_of(const std::string& asked, const video::VideoInfo& clip);

}  // namespace vvr::app
