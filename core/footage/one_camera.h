#pragma once

#include <string>
#include <vector>

#include "core/footage/recorder_names.h"
#include "core/footage/segment.h"

// A recording has one camera.
namespace vvr::footage {

/// A file's absolute path, so that results don't depend on the working folder. Streams keep their names.
std::string whole_path(const std::string& name);

/// Sets the camera of each segment by file name and by folders that differ. Returns the common camera, or an empty
/// string if unknown.
/// \param name name of the recording, for the message
/// \param join whether to accept files of several cameras
/// \throws Error usage if they are of several cameras; the message says how to choose one
std::string find_camera(const std::string& name, std::vector<Segment>& segments, const RecorderNames& schemes,
                        bool join);

}  // namespace vvr::footage
