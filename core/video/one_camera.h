#pragma once

#include <string>
#include <vector>

#include "core/video/recording.h"

// Files that are one recording together are of one camera.
namespace vvr::video {

/// A file's path from the root, so that its folders tell the same wherever one stands; streams stay as they are.
std::string whole_path(const std::string& name);

/// Fills in which camera each file is of, by its name and by folders in which the files differ, and returns the camera
/// of all; empty where nobody knows.
/// \param name of the recording, for the error
/// \param join whether files of several cameras are one recording all the same
/// \throws Error usage when they are of several, with a way to choose one of them
std::string find_camera(const std::string& name, std::vector<Segment>& segments, const RecorderNames& layouts,
                        bool join);

/// Throws where no name tells when some files were recorded, and their sizes or rates differ besides: nothing says that
/// they belong together.
/// \throws Error usage
void require_related(const Recording& recording);

}  // namespace vvr::video
